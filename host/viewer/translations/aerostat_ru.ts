<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU">
<context>
    <name>Controls</name>
    <message>
        <source>Biome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells a side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snow line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snow and water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sea</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sea level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of plants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High cloud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Valley fog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top of the fog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sight in the fog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>East</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>South</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height counts from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples a pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Development</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Near the balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Far, the balloon small</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Against the other side</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Schema</name>
    <message>
        <source>A scene of the renderer aerostat. Lengths in metres, angles in degrees, y up, azimuth 0 = north (-z), 90 = east (+x). Whatever a file leaves out comes from its biome and view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where editors find this schema.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version of the format: 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The switch that brings terrain shape, colours, light, sky, air and balloon colours. Either its name alone or an object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The biome&apos;s name alone; everything else by default.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The biome with changes to its ground and sea.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The switch that brings terrain shape, colours, light, sky, air and balloon colours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the ground is coloured, by height, slope and noise. Every default comes with the biome.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of the first tone of what grows or lies on gentle ground. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of its second tone; noise mixes the two. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of the first tone of bare rock. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of its second tone. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slopes in degrees from which rock begins and beyond which it is complete, 0 to 90, the smaller one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of snow; keep it below 0.95, or it clips. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean height in metres above which snow lies, -1000000 to 1000000; 1000000 means no snow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in metres of the zone in which the snow thins out, 0 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slopes in degrees up to which snow is full and beyond which none holds, 0 to 90, the smaller one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of dry sand at the shore. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sand lies up to this height above the sea, in metres, -1000000 to 1000000; -1000000 means no beach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest wavelength of the detail in colour and relief, in metres, above 0 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the detail in the normal, 0 (none) to 10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavelength of wind ripples in metres, 0 (none) to 1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of trees. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in metres up to which trees grow, -100000 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the ground that trees cover below that height, 0 (none) to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of a tree&apos;s crown in metres, 0.1 to 1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sea: a plane at level_m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether there is a sea.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the plane in metres, -1000000 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absorption per metre of water by Beer and Lambert, for [red, green, blue], 0 to 100.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of deep water. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of the sand under the water. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavelength of the largest waves in metres, above 0 to 10000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square slope of the waves, 0 (a mirror) to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ground: a square of cells x cells quads around center, whose spacing grows outwards. Defaults come with the biome.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overall shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the noise, 0 to 4294967295; another number, another land.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quads per side, 2 to 4096.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side of the square in metres, 10 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[x, z] in metres of the finest cells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cell size at the rim over that at the centre, 1 (even) to 1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughly from the lowest valleys to the highest peaks, in metres, 0 to 20000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to every height, in metres, -100000 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavelength of the first octave in metres, 1 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude of the domain distortion in metres, 0 (none) to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavelength of the domain distortion in metres, 1 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent of the heights, 0.1 to 10: above 1 widens valleys, below 1 widens heights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Octaves of Perlin noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the octaves are summed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of octaves, 1 to 20.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency ratio of successive octaves, 1 to 4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude ratio of successive octaves, 0 to 8.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ridged noise only: offset in (offset - |n|)^2, 0 to 4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind-blown sand, for terrain of kind dunes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth in degrees that the wind blows towards, -360 to 360.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crest to crest along the wind, in metres, 1 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trough to crest of the largest dunes, in metres, 0 to 5000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plants and stones that stand on the ground; what grows where comes with the biome.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether anything stands on the ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plants per area against the biome&apos;s usual number, 0 (none) to 4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on the height of every plant and stone, 0.1 to 10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far from the camera single trees stand, in metres, 10 to 12000; beyond it woods are painted on the ground. Smaller growth reaches less far in proportion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another number, other plants, 0 to 4294967295.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hot-air balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether there is a balloon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of the basket&apos;s floor. [x, y, z] in metres, y up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the position&apos;s y counts from: the sea (absolute) or the ground below (the default).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest diameter of the envelope in metres, 2 to 200.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn of the whole balloon about its axis in degrees, -360 to 360.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the envelope&apos;s gores, 6 to 128.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the colours are laid over the envelope.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the fabric, 1 to 64 of them; the pattern repeats them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of one fabric. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The eye.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the defaults put the eye: outside the balloon or in its basket.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the eye is. In the basket view, left out, it stands inside at eye height. [x, y, z] in metres, y up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point in the middle of the picture. In the basket view, left out, the eye looks straight ahead. [x, y, z] in metres, y up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the y of position and target counts from: the sea (absolute), the ground below each, or the floor of the balloon&apos;s basket (the default).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction that is upright in the picture; its length does not matter, but must not be 0. Components -1000 to 1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical angle of view in degrees, 1 to 170.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sun. Give its direction, or the two angles, or date, time, latitude and longitude.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction towards the sun; any length but 0. Components -1000000 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth in degrees, 0 = north (-z), 90 = east (+x), -360 to 360.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height above the horizon in degrees, -90 to 90.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day at which it stands where it stands, as 2024-06-21.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of that day, as 06:30 or 06:30:15, universal time unless an offset follows: 06:30+02:00.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latitude of the place in degrees, north positive, -90 to 90.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitude of the place in degrees, east positive, -180 to 180.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the light outside the air; the largest component should be 1. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irradiance of a plane that faces the sun outside the air, 0 to 1000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether it casts shadows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether its shadows have the soft edges of its disc. Left out, the quality says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point lights, at most 16.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it is, heights above the sea. [x, y, z] in metres, y up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the light. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irradiance times the square of the distance in metres, 0 to 1000000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is in the sky beside sun and air.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the sky that thin high cloud covers, 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the clouds above the eye in metres, 100 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether what is near keeps the sky&apos;s light off. Left out, the quality says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far away it may be for that, in metres, 0.01 to 100000; the farther, the less it counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gases of the air and the ground under it; sky, sunlight and distance take their colours from them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the molecules, relative to the Earth&apos;s, 0 (none) to 10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ozone in Dobson units, 0 to 3000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of the land around, whose light the air sends back. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Droplets and dust in the air: with the molecules, extinction 3.912 / visibility at sea level, falling off with height.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance in metres at which contrast falls to 2 %, 10 to 10000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in metres over which the haze falls to 1/e, 1 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extinction goes with the wavelength to the power of minus this, -1 to 4: 0 (grey) for fog, 0.3 for dust, 1.3 for fine haze.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean cosine of the angle by which light is deflected, 0 (evenly) to 0.95 (forwards).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the extinction that is scattering, the rest is absorbed. [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog that fills the valleys, even up to its top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether there is fog.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance in metres at which contrast inside it falls to 2 %, 10 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean height of its top above the sea in metres, -100000 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in metres over which it thins out, 1 to 10000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far its top goes up and down, in metres, 0 (level) to 10000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wavelength of its top&apos;s ups and downs in metres, 10 to 100000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phong coefficients per object; ground and sea take their colours from the biome.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How normals and colours vary over a triangle: not at all, colours interpolated, or normals interpolated (the default).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets /image/spp, /sun/soft_shadows and /sky/ambient_occlusion where the scene leaves them out: draft is 1, false, false; standard (the default) 4, true, true; final 64, true, true.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width in pixels, 1 to 32768.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in pixels, 1 to 32768.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples per pixel, 1 to 65536.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the samples, 0 to 4294967295.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconstruction filter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure in stops: each doubles the brightness, -30 to 30. Left out, it follows from the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phong coefficients of one object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of the object&apos;s own colours. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of the sky&apos;s light, 0 to 10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of Lambert&apos;s term, 0 to 10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor of the highlight, 0 to 10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent of the highlight, 1 to 10000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the light on the far side that shines through, 0 to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light of its own, times the colour of the vertices. Linear Rec. 709 [red, green, blue], each 0 to 1000000.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>snow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tropical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sea</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gouraud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>final</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chevrons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spiral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rainbow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::CameraControl</name>
    <message>
        <source>Free View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from the Basket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from Outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look Around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Closer or Away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the Balloon</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ColorEditor</name>
    <message>
        <source>One more colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One colour less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the Balloon</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ControlRow</name>
    <message>
        <source>Dice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The seed before the dice was thrown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::Document</name>
    <message>
        <source>Out of memory</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ExportDialog</name>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the scene says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name that ends in .exr keeps the light as it is, with distances, normals and objects in layers; any other gives a PNG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenEXR (*.exr)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ExportJob</name>
    <message>
        <source>Tracing rays…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Building the world…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of memory</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::MainWindow</name>
    <message>
        <source>Controls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the Automatic Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unnamed scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] — Aerostat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Snowy Mountains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tropical Island</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dunes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;Image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as Command &amp;Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;Everything but the Biome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit the Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixel for Pixel (&amp;1:1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the &amp;Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From &amp;Outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the &amp;Basket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Put the Balloon by a Click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mouse and Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Aerostat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Aerostat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Aerostat %1&lt;/h3&gt;&lt;p&gt;Pictures of a hot-air balloon before a mountain landscape, ray-traced on OpenCL.&lt;/p&gt;&lt;p&gt;MIT licence. Uses Qt %2 under the LGPL, version 3.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>building the land…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>building trees…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compiling kernels…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uploading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/%1 of the size</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) a pixel</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>coarse land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Mrays/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eye %1 m above ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  ·  %2 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::NumberEditor</name>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::Panels</name>
    <message>
        <source>&amp;Land</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Li&amp;ght</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the basket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the camera stands: before the balloon, in its basket, or where you move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras that suit any scene, counted from the balloon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the Balloon by a Click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then click on the ground below the place for the balloon (or Ctrl+click at any time)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual sizes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What computes the picture. Not part of the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::PictureView</name>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::SceneFiles</name>
    <message>
        <source>Scenes (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene was changed. Save it first?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ShortcutsDialog</name>
    <message>
        <source>Drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn around what is looked at; in the basket, look around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right drag, Shift+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel, Page Up, Page Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closer, away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aim there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>put the balloon above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W A S D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fly ahead, left, back, right (Shift: fast)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q, E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>down, up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows, Shift+arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn around it, look around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shift the picture at 1:1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click on a name, Ctrl+Backspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back to the default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows on the sun&apos;s disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the sun (Shift: by 10°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dismiss a message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse and Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the controls</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::SunDisc</name>
    <message>
        <source>Sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the sun: the rim is the horizon, the middle the zenith, north is up. Double-click for the default.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <comment>north</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E</source>
        <comment>east</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S</source>
        <comment>south</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <comment>west</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::SunPanel</name>
    <message>
        <source>By date, time and place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day at which the sun stands where it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of that day, by the clock of the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UTC </source>
        <comment>before an offset in hours</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far that clock is ahead of universal time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the Sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the Sun by Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the Sun</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Sets up a picture of aerostat by eye.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene file to open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What computes, as of aerostat render</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
