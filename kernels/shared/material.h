#ifndef AEROSTAT_SHARED_MATERIAL_H
#define AEROSTAT_SHARED_MATERIAL_H

#include "layout.h"

/* Kinds of materials: which code works out what a point of the surface is like. */
#define AERO_MATERIAL_PLAIN 0    /* the coefficients and the colours of the vertices are all */
#define AERO_MATERIAL_GROUND 1   /* colour and detail by the rules of AeroGround */
#define AERO_MATERIAL_WATER 2    /* waves over a bed, by AeroWater; vertices hold the depth */
#define AERO_MATERIAL_ENVELOPE 3 /* cloth with tapes and seams, lit from within */
#define AERO_MATERIAL_SKIRT 4    /* cloth that hangs in folds */
#define AERO_MATERIAL_SUEDE 5    /* grained leather */

/* The number of materials in the table of a scene, and which of them the height grid has. */
#define AERO_MATERIAL_COUNT 12
#define AERO_GRID_MATERIAL 0

/* Coefficients of one material. Colours are linear Rec. 709. */
typedef struct AeroMaterial {
  aero_uint kind; /* AERO_MATERIAL_... */
  aero_float albedo[3];
  aero_float ambient, diffuse, specular, shininess;
  aero_float translucency;
  aero_float emission[3];
  aero_uint burner_light; /* 1: the balloon's burners light it */
} AeroMaterial;

AERO_ASSERT_LAYOUT(AeroMaterial, 52);

#endif
