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

#define AERO_MATERIAL_MODEL 6 /* of a model from a file: metal or not, rough, with textures */

/* The most materials of a scene: those of scene::MaterialId, then those of models from files. */
#define AERO_FIXED_MATERIALS 32
#define AERO_MAX_FILE_MATERIALS 256
#define AERO_MAX_MATERIALS (AERO_FIXED_MATERIALS + AERO_MAX_FILE_MATERIALS)

/* The index of the height grid's material. */
#define AERO_GRID_MATERIAL 0

/* What a material has to do with the light of the burners. */
#define AERO_BURNER_NOTHING 0
#define AERO_BURNER_LIT 1   /* the burners of its balloon light it */
#define AERO_BURNER_FLAME 2 /* it is their flame */

/* What the opacity of a model's surface means. */
#define AERO_OPAQUE 0  /* nothing: the surface hides what is behind it */
#define AERO_MASKED 1  /* below the cutoff, the surface is not there */
#define AERO_BLENDED 2 /* the share of rays that the surface stops */

/* Coefficients of one material. Colours are linear Rec. 709. */
typedef struct AeroMaterial {
  aero_uint kind; /* one of AERO_MATERIAL_... */
  aero_float albedo[3];
  aero_float ambient, diffuse, specular, shininess;
  aero_float translucency;
  aero_float emission[3];
  aero_uint burner_light; /* one of AERO_BURNER_... */
  /* For models from files. `specular` is the reflectance at normal incidence of what is no metal.
   * Each texture is the place of its header in the buffer of texels. Those that a material has not
   * are AeroScene::white_texture. */
  aero_float metallic, roughness; /* metal: 1; the square of the roughness is GGX's alpha */
  aero_float opacity, cutoff;
  aero_uint see_through; /* one of AERO_OPAQUE, AERO_MASKED and AERO_BLENDED */
  aero_float normal_scale;
  aero_uint color_texture, metal_texture, normal_texture, emission_texture;
} AeroMaterial;

AERO_ASSERT_LAYOUT(AeroMaterial, 92);

#endif
