# Completion of aerostat-viewer's command line for fish.

function __aerostat_viewer_devices
    printf '%s\n' auto cpu gpu all
    aerostat devices --json 2>/dev/null | string replace -rf '.*"selector": *"([^"]*)".*' '$1'
end

complete -c aerostat-viewer -f
complete -c aerostat-viewer -a '(__fish_complete_suffix .json)'
complete -c aerostat-viewer -x -l device -a '(__aerostat_viewer_devices)' -d 'OpenCL devices that render'
complete -c aerostat-viewer -s h -l help -d 'Print the help and exit'
complete -c aerostat-viewer -l help-all -d 'Print the help with the options of Qt and exit'
complete -c aerostat-viewer -s v -l version -d 'Print the version and exit'
