/* Step 6 adds light. This file comes after rays.clh and traverse_tree.clh.
 *
 * Phong's local model adds three parts: light from everywhere (ambient), light that a matt
 * surface scatters in all directions (diffuse), and a highlight around the mirrored direction
 * (specular). The last two parts depend on whether the sun is visible from the point, which takes
 * one more ray. */

typedef struct {
  float3 albedo; /* share of the light that is scattered */
  float specular, shininess;
} Material;

/* A place of the mesh and the normal there. */
typedef struct {
  float3 place, normal;
} Surface;

Surface surface_at(__global const Triangle* triangles, const Ray* ray, const Hit* hit) {
  const Triangle triangle = triangles[hit->triangle];
  const float3 a = vector(triangle.v0), b = vector(triangle.v1), c = vector(triangle.v2);
  Surface surface;
  surface.place = a + hit->u * (b - a) + hit->v * (c - a);
  surface.normal = normalize(cross(b - a, c - a));
  if (dot(surface.normal, ray->direction) > 0.0f) surface.normal = -surface.normal;
  return surface;
}

/* Returns grass for low places, rock for steep ones, snow for high ones, and striped cloth for
 * the balloon. */
Material material_at(const Surface* surface, int is_balloon) {
  Material material = {(float3)(0.16f, 0.24f, 0.08f), 0.02f, 8.0f};
  if (is_balloon) {
    const float angle = atan2(surface->normal.z, surface->normal.x);
    const int gore = (int)floor(angle * 12.0f / 3.14159265f + 0.5f);
    material.albedo = gore % 2 == 0 ? (float3)(0.75f, 0.08f, 0.05f) : (float3)(0.85f, 0.8f, 0.7f);
    material.specular = 0.15f;
    material.shininess = 24.0f;
  } else if (surface->place.y > 0.1f) {
    material.albedo = (float3)(0.8f, 0.82f, 0.86f);
    material.specular = 0.1f;
  } else if (surface->normal.y < 0.85f) {
    material.albedo = (float3)(0.3f, 0.28f, 0.26f);
  }
  return material;
}

float3 sky(float3 direction) {
  const float height = fmax(normalize(direction).y, 0.0f);
  return mix((float3)(0.75f, 0.82f, 0.9f), (float3)(0.2f, 0.4f, 0.75f), sqrt(height));
}

/* Returns the light that a surface sends to the eye. `to_sun` points towards the sun. `visible`
 * is 0 in shadow. */
float3 phong(const Surface* surface, const Material* material, float3 to_eye, float3 to_sun,
             float visible) {
  const float3 sun = (float3)(1.7f, 1.55f, 1.3f);
  const float3 ambient = (float3)(0.22f, 0.28f, 0.38f);
  const float facing = fmax(dot(surface->normal, to_sun), 0.0f) * visible;
  const float3 mirrored = 2.0f * dot(surface->normal, to_sun) * surface->normal - to_sun;
  const float highlight =
      facing > 0.0f ? pow(fmax(dot(mirrored, to_eye), 0.0f), material->shininess) : 0.0f;
  return material->albedo * (ambient + facing * sun) + material->specular * highlight * sun;
}

/* Returns the value that a screen shows for some light, by the transfer function of sRGB. */
float3 screen_value(float3 light) {
  const float3 c = clamp(light, 0.0f, 1.0f);
  return select(1.055f * pow(c, 1.0f / 2.4f) - 0.055f, 12.92f * c, c <= 0.0031308f);
}

__kernel void render(Camera camera, __global const Node* nodes, __global const Triangle* triangles,
                     float balloon_above_y, __global uchar* rgb, __global uint* in_shadow) {
  const int x = (int)get_global_id(0), y = (int)get_global_id(1);
  const int width = (int)get_global_size(0), height = (int)get_global_size(1);
  const float3 to_sun = normalize((float3)(0.6f, 0.4f, 0.1f));
  Work work = {0, 0};
  float3 sum = (float3)(0.0f);
  uint shadows = 0;
  for (int sample = 0; sample < 4; ++sample) { /* four samples smooth edges */
    const float dx = 0.25f + 0.5f * (float)(sample % 2), dy = 0.25f + 0.5f * (float)(sample / 2);
    const Ray ray = camera_ray(&camera, (float)x + dx, (float)y + dy, width, height);
    const Hit hit = traverse_tree(nodes, triangles, &ray, &work);
    if (hit.triangle == NO_TRIANGLE) {
      sum += sky(ray.direction);
      continue;
    }
    const Surface surface = surface_at(triangles, &ray, &hit);
    const Material material = material_at(&surface, surface.place.y > balloon_above_y);
    /* The shadow ray begins a little above the surface. Otherwise rounding would let it hit the
     * triangle that it comes from. */
    const Ray to_light = make_ray(surface.place + 1e-4f * surface.normal, to_sun);
    const Hit blocker = traverse_tree(nodes, triangles, &to_light, &work);
    const float visible = blocker.triangle == NO_TRIANGLE ? 1.0f : 0.0f;
    shadows += visible == 0.0f ? 1u : 0u;
    sum += phong(&surface, &material, -normalize(ray.direction), to_sun, visible);
  }
  const float3 color = 255.0f * screen_value(0.25f * sum);
  const int pixel = y * width + x;
  rgb[3 * pixel] = convert_uchar_sat_rte(color.x);
  rgb[3 * pixel + 1] = convert_uchar_sat_rte(color.y);
  rgb[3 * pixel + 2] = convert_uchar_sat_rte(color.z);
  in_shadow[pixel] = shadows;
}
