#ifndef AEROSTAT_SHARED_MATERIAL_H
#define AEROSTAT_SHARED_MATERIAL_H

#include "layout.h"

/* Kinds of materials. The kind chooses the code that computes the look of a point on the
 * surface. */
#define AERO_MATERIAL_PLAIN 0    /* the coefficients and the colours of the vertices alone */
#define AERO_MATERIAL_GROUND 1   /* colour and detail by the rules of AeroGround */
#define AERO_MATERIAL_WATER 2    /* waves over a bed, by AeroWater; vertices hold the depth */
#define AERO_MATERIAL_ENVELOPE 3 /* cloth with tapes and seams, lit from within */
#define AERO_MATERIAL_SKIRT 4    /* cloth that hangs in folds */
#define AERO_MATERIAL_SUEDE 5    /* grained leather */

/* The most materials that a scene can have, and the index of the height grid's material. */
#define AERO_MAX_MATERIALS 32
#define AERO_GRID_MATERIAL 0

/* What a material has to do with the light of the burners. */
#define AERO_BURNER_NOTHING 0
#define AERO_BURNER_LIT 1   /* the burners of its balloon light it */
#define AERO_BURNER_FLAME 2 /* it is their flame */

/* Coefficients of one material. Colours are linear Rec. 709. */
typedef struct AeroMaterial {
  aero_uint kind; /* one of AERO_MATERIAL_... */
  aero_float albedo[3];
  aero_float ambient, diffuse, specular, shininess;
  aero_float translucency;
  aero_float emission[3];
  aero_uint burner_light; /* one of AERO_BURNER_... */
} AeroMaterial;

AERO_ASSERT_LAYOUT(AeroMaterial, 52);

#endif
