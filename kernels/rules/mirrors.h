#ifndef AEROSTAT_RULES_MIRRORS_H
#define AEROSTAT_RULES_MIRRORS_H

/* The root mean square slope of waves up to which water mirrors what is there. In rougher water
 * nothing can be made out. The host then leaves the rays out, and the device the clouds. Chosen by
 * eye. */
#define MIRRORING_SLOPE 0.05f

#endif
