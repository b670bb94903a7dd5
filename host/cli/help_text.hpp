#pragma once

/// The texts of --help apart from the options.
namespace aerostat::cli {

inline constexpr const char* kDescription =
    "Renders pictures of a hot-air balloon before a mountain landscape, by ray tracing on OpenCL.";

inline constexpr const char* kMainFooter = R"(Examples:
  aerostat render snow
  aerostat render davos.tif
  aerostat film snow
  aerostat scenes
  aerostat devices
  aerostat COMMAND --help

Environment:
  AEROSTAT_DEVICE      the devices, if --device is not given
  AEROSTAT_SCENE_DIR   the folder of the scenes that came with aerostat
  AEROSTAT_KERNEL_DIR  reads the kernels from this folder instead of the program
  AEROSTAT_KERNEL_BINARIES
                       on or off: whether compiled programs are kept in the user's cache folder; by default for drivers that keep none themselves
  AEROSTAT_DEVICE_TIMEOUT
                       how long a device may take for a launch before it is given up, such as 10m; by default 300s, 0 for never
  AEROSTAT_OIDN_DIR    the folder of Open Image Denoise's library for --denoise, if the system's loader does not find it
  POCL_CACHE_DIR       where PoCL keeps compiled kernels; by default aerostat/pocl in the user's cache folder
  NO_COLOR             if set, nothing is coloured

Exit codes: 0 done, 64 wrong command line, 65 bad scene, frames or bands, 69 no such device, no Open Image Denoise or no ffmpeg, 70 internal fault, 74 file cannot be read or written, 75 out of memory, out of time or device lost, 130 and 143 interrupted.)";

inline constexpr const char* kRenderFooter = R"(Examples:
  aerostat render scenes/snow.json
  aerostat render scenes/tropical.json -o beach.png --width 1920 --height 1080 --spp 16
  aerostat render scenes/sand.json -o layers.exr --spp 1
  aerostat render scenes/snow.json --set /sun/elevation_deg=6 --set /balloon/pattern=spiral
  aerostat render scenes/snow.json --crop 400,200,880,520 --device cpu --stats
  aerostat render scenes/snow.json --device all
  aerostat render davos.tif
  aerostat render davos.tif --labels peaks.csv -o davos.png
  aerostat render davos.tif -o relief.tif
  aerostat dump snow | aerostat render - -o - --format exr > layers.exr

Devices:
  A name is platform:device (as 'aerostat devices' lists them), a part of a name, cpu, gpu or auto. 0:0,1:0 is two devices that share the picture, all is every device there is; 0:0/2 is a device cut into 2 parts of its compute units, 0:0/2.1 the second of them. --memory-limit holds for each device. Devices of one lane width give the same picture, bit by bit, whether together or alone.)";

inline constexpr const char* kContactSheetFooter = R"(Examples:
  aerostat contact-sheet scenes/snow.json
  aerostat contact-sheet scenes/sand.json --seeds 1-6,20-25 --quality draft -o dunes.png
  aerostat contact-sheet scenes/tropical.json --columns 3 --tile-width 480 --set /balloon/enabled=false
  aerostat contact-sheet davos.tif --views 12

Each tile is exposed by what it shows, unless the scene says /image/exposure_ev; the number below it is its /terrain/seed.)";

inline constexpr const char* kFilmFooter = R"(Examples:
  aerostat film snow
  aerostat film scenes/snow.json -o flight.mp4 --preview
  aerostat film my.json -o flight.mp4 --quality final
  aerostat film my.json -o frames/####.exr --frames 1-500:2
  aerostat film my.json -o frames/####.png --shard 3/8 --time-limit 2h
  aerostat film my.json -o frames/####.png --verify

/film in the scene says how long the film is and what moves. The frames stand on disk first, each of them whole or not at all, and the same command goes on where it was stopped: frames that are there and were made from the same scene, size and quality by this version are kept, and others are made anew. Films are encoded by the program ffmpeg. When all frames are there, a sheet of small pictures of them is written to x-sheet.png, or to contact-sheet.png beside the frames.)";

inline constexpr const char* kMergeFooter = R"(Examples:
  aerostat render my.json -o bands/1.exr --width 16000 --height 9000 --shard 1/2
  aerostat render my.json -o bands/2.exr --width 16000 --height 9000 --shard 2/2
  aerostat merge bands/*.exr -o big.png

The picture has the bits that one render of the whole would have written. All rows must be there, and all bands must be of one scene, size, quality and version; otherwise nothing is written, and a message names what is wrong.)";

inline constexpr const char* kNewFooter = R"(Examples:
  aerostat new davos.tif
  aerostat new davos.tif --view 3 --set /biome=snow -o winter.json
  aerostat new tiles/ -o - | aerostat render - -o picture.png

What the scene leaves open is chosen: place, camera and balloon, sun, biome and size. Each choice is said, and stands in the file to be changed. 'aerostat contact-sheet davos.tif --views 12' shows the views.)";

inline constexpr const char* kScenesFooter = R"(Examples:
  aerostat scenes
  cp "$(aerostat scenes --folder)/snow.json" my.json

Every command that takes a scene also takes the name of one of them, without folder and extension, unless a file has that name.)";

inline constexpr const char* kDevicesFooter = R"(Examples:
  aerostat devices
  aerostat devices --json)";

inline constexpr const char* kCheckFooter = R"(Examples:
  aerostat check scenes/snow.json
  aerostat check my.json --set /image/width=800
  aerostat check flight.igc
  aerostat check flight.gpx --json
  aerostat check flight.igc --land davos.tif
  aerostat check davos.tif

Prints to stderr that the scene is right, or a line for each of its faults. For elevation data, it prints files, extent, heights, gaps, and what was guessed and chosen. For a track (IGC, GPX, KML or KMZ, told by its content) it prints fixes, take-off, landing, heights, gaps and what was mended; with --land, also how high above the ground it was. Of a scene with a film it prints the way of the balloon: where the wind carries it, how high above the ground, and the wind there.)";

inline constexpr const char* kDumpFooter = R"(Examples:
  aerostat dump scenes/snow.json
  aerostat dump scenes/snow.json --set /terrain/seed=7 > seed7.json
  aerostat dump sand --view)";

inline constexpr const char* kExportFooter = R"(Examples:
  aerostat export scenes/snow.json -o world.ply
  aerostat export scenes/sand.json -o dunes.obj --set /terrain/cells=256 --plants seen
  aerostat export my.json -o world.glb)";

inline constexpr const char* kArtworkFooter = R"(Examples:
  aerostat artwork --template -o gores.svg
  aerostat artwork my.json --template --balloon 2 -o gores.svg

Draw on the template, for example in Inkscape, and name the file in the scene: "artwork": [{"file": "gores.svg", "wrap": "gores"}]. The guides are left out.)";

}  // namespace aerostat::cli
