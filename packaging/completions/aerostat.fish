# Completion of aerostat's command line for fish.

function __aerostat_scenes
    aerostat scenes 2>/dev/null | string replace -r ' +' \t
    __fish_complete_suffix .json
    __fish_complete_suffix .tif
    __fish_complete_suffix .hgt
    __fish_complete_suffix .asc
end

function __aerostat_devices
    printf '%s\n' auto cpu gpu all
    aerostat devices --json 2>/dev/null | string replace -rf '.*"selector": *"([^"]*)".*' '$1'
end

complete -c aerostat -f
complete -c aerostat -s h -l help -d 'Print the help and exit'
complete -c aerostat -n __fish_use_subcommand -l version -d 'Print the version and exit'
complete -c aerostat -n __fish_use_subcommand -a render -d 'Render a scene to a PNG or EXR file'
complete -c aerostat -n __fish_use_subcommand -a contact-sheet -d 'Render many terrain seeds onto one sheet'
complete -c aerostat -n __fish_use_subcommand -a film -d 'Render the film of a scene'
complete -c aerostat -n __fish_use_subcommand -a merge -d 'Join the bands of a large picture'
complete -c aerostat -n __fish_use_subcommand -a new -d 'Write a scene around a file of elevation data'
complete -c aerostat -n __fish_use_subcommand -a scenes -d 'List the scenes that came with aerostat'
complete -c aerostat -n __fish_use_subcommand -a devices -d 'List OpenCL platforms and devices'
complete -c aerostat -n __fish_use_subcommand -a check -d 'Validate a scene, or report on elevation data or a flight track'
complete -c aerostat -n __fish_use_subcommand -a dump -d 'Print the scene with every default filled in'
complete -c aerostat -n __fish_use_subcommand -a export -d 'Write the triangles of the world to a file'
complete -c aerostat -n __fish_use_subcommand -a artwork -d 'Write a template for artwork on the envelope'

set -l scene 'render contact-sheet film new check dump export artwork'
complete -c aerostat -n "__fish_seen_subcommand_from $scene" -a '(__aerostat_scenes)'
complete -c aerostat -n "__fish_seen_subcommand_from $scene" -x -l set -d 'Change the scene: pointer=value'
complete -c aerostat -n '__fish_seen_subcommand_from render contact-sheet film check dump export artwork' -l allow-external-paths -d 'Let the scene name files outside of its folder'
complete -c aerostat -n '__fish_seen_subcommand_from render contact-sheet film check dump export artwork' -l sandbox -d 'Keep aerostat from other files and the network'

set -l rendering 'render contact-sheet film'
complete -c aerostat -n "__fish_seen_subcommand_from $rendering" -x -l quality -a 'draft standard final' -d 'Quality of samples, soft shadows and ambient occlusion'
complete -c aerostat -n "__fish_seen_subcommand_from $rendering" -x -l device -a '(__aerostat_devices)' -d 'OpenCL devices that render'
complete -c aerostat -n "__fish_seen_subcommand_from $rendering" -x -l lanes -a '1 4 8 16' -d 'Rays per work-item'
complete -c aerostat -n "__fish_seen_subcommand_from $rendering" -x -l memory-limit -d 'Largest amount of memory to use on each device'
complete -c aerostat -n "__fish_seen_subcommand_from $rendering" -l skip-self-test -d 'Do not test devices at their first use'
complete -c aerostat -n "__fish_seen_subcommand_from $rendering" -s q -l quiet -d 'Print only errors'

complete -c aerostat -n '__fish_seen_subcommand_from merge' -a '(__fish_complete_suffix .exr)'
complete -c aerostat -n '__fish_seen_subcommand_from merge' -s q -l quiet -d 'Print only errors'

set -l output 'render contact-sheet film merge new export artwork'
complete -c aerostat -n "__fish_seen_subcommand_from $output" -r -F -s o -l output -d 'The file to write'

complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l format -a 'png exr tif' -d 'Format of the picture'
complete -c aerostat -n '__fish_seen_subcommand_from export' -x -l format -a 'ply obj glb gltf' -d 'Format of the mesh'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l width -d 'Pixels across'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l height -d 'Pixels down'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l spp -d 'Samples per pixel'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l seed -d 'Seed of the samples'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l crop -d 'Render only a part: x0,y0,x1,y1'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l shard -d 'Render only one of several bands: k/n'
complete -c aerostat -n '__fish_seen_subcommand_from render' -r -F -l labels -d 'Places to name in the picture'
complete -c aerostat -n '__fish_seen_subcommand_from render' -r -F -l labels-json -d 'Where the places are in the picture'
complete -c aerostat -n '__fish_seen_subcommand_from render' -l world-file -d 'Tell programs for maps where the picture lies'
complete -c aerostat -n '__fish_seen_subcommand_from render' -l denoise -d 'Take the noise out of the picture'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l time-limit -d 'End after this time with the picture so far'
complete -c aerostat -n '__fish_seen_subcommand_from render' -l save-partial -d 'On Ctrl-C, write the picture so far'
complete -c aerostat -n '__fish_seen_subcommand_from render' -r -F -l checkpoint -d 'Save the samples to this file and go on with them'
complete -c aerostat -n '__fish_seen_subcommand_from render' -x -l checkpoint-every -d 'The time between two savings'
complete -c aerostat -n '__fish_seen_subcommand_from render' -l stats -d 'Report rays, times and memory'

complete -c aerostat -n '__fish_seen_subcommand_from contact-sheet' -x -l seeds -d 'Terrain seeds and ranges of them'
complete -c aerostat -n '__fish_seen_subcommand_from contact-sheet' -x -l views -d 'Number of views of real land'
complete -c aerostat -n '__fish_seen_subcommand_from new' -x -l view -d 'Which of the views to take'
complete -c aerostat -n '__fish_seen_subcommand_from contact-sheet' -x -l columns -d 'Tiles across'
complete -c aerostat -n '__fish_seen_subcommand_from contact-sheet' -x -l tile-width -d 'Pixels across a tile'

complete -c aerostat -n '__fish_seen_subcommand_from film' -x -l codec -a 'h264 av1 prores lossless' -d 'How the film is encoded'
complete -c aerostat -n '__fish_seen_subcommand_from film' -x -l frames -d 'Only these frames'
complete -c aerostat -n '__fish_seen_subcommand_from film' -x -l shard -d 'Only one of several parts: k/n'
complete -c aerostat -n '__fish_seen_subcommand_from film' -x -l time-limit -d 'Begin no further frame after this time'
complete -c aerostat -n '__fish_seen_subcommand_from film' -l verify -d 'List frames that are missing, broken or foreign'
complete -c aerostat -n '__fish_seen_subcommand_from film' -l preview -d 'Render small frames of one sample'
complete -c aerostat -n '__fish_seen_subcommand_from film' -x -l width -d 'Pixels across'
complete -c aerostat -n '__fish_seen_subcommand_from film' -x -l height -d 'Pixels down'

complete -c aerostat -n '__fish_seen_subcommand_from scenes' -l folder -d 'Print only the folder of the scenes'
complete -c aerostat -n '__fish_seen_subcommand_from devices' -l json -d 'Print JSON'
complete -c aerostat -n '__fish_seen_subcommand_from check' -x -l device -a '(__aerostat_devices)' -d 'Compare the memory of this device with what a render needs'
complete -c aerostat -n '__fish_seen_subcommand_from check' -l json -d 'Print the report on elevation data or a track as JSON'
complete -c aerostat -n '__fish_seen_subcommand_from check' -l land -r -d 'Elevation data below a track'
complete -c aerostat -n '__fish_seen_subcommand_from dump' -l view -d 'Print what another renderer needs beside triangles'
complete -c aerostat -n '__fish_seen_subcommand_from export' -x -l plants -a 'none seen all' -d 'Plants to write'
complete -c aerostat -n '__fish_seen_subcommand_from export' -x -l most-triangles -d 'Write nothing if there are more triangles'
complete -c aerostat -n '__fish_seen_subcommand_from artwork' -l template -d 'Draw the unrolled gores, to draw on'
complete -c aerostat -n '__fish_seen_subcommand_from artwork' -x -l balloon -d 'Which balloon of the scene'
