# Completion of aerostat's command line for bash.

_aerostat_commands='render contact-sheet film merge new scenes devices check dump export artwork'

_aerostat_options() {
  local common='--help' scene='--help --set --allow-external-paths --sandbox' device='--device --lanes --memory-limit --skip-self-test --quiet'
  case $1 in
    render)
      echo "$scene $device --output --format --width --height --quality --spp --seed --crop --shard --labels --labels-json --world-file --denoise --time-limit --save-partial --checkpoint --checkpoint-every --stats" ;;
    contact-sheet) echo "$scene $device --seeds --views --output --columns --tile-width --quality" ;;
    film)
      echo "$scene $device --output --codec --frames --shard --time-limit --verify --preview --width --height --quality" ;;
    merge) echo "$common --output --quiet" ;;
    new) echo "$common --set --output --view" ;;
    scenes) echo "$common --folder" ;;
    devices) echo "$common --json" ;;
    check) echo "$scene --json --device --land" ;;
    dump) echo "$scene --view" ;;
    export) echo "$scene --output --format --plants --most-triangles" ;;
    artwork) echo "$scene --template --balloon --output" ;;
    *) echo "$common --version" ;;
  esac
}

# Prints the folders, and the files whose names end with one of the arguments from $2 on.
_aerostat_files() {
  local word=$1 ending
  shift
  compgen -d -- "$word"
  for ending in "$@"; do
    compgen -f -X "!*.$ending" -- "$word"
  done
}

_aerostat_scenes() {
  compgen -W "$("$1" scenes 2>/dev/null | cut -d ' ' -f 1)" -- "$2"
  _aerostat_files "$2" json tif tiff hgt zip asc dem dt0 dt1 dt2 nc img png exr r16 r32 raw bil
}

_aerostat_devices() {
  local found
  found=$("$1" devices --json 2>/dev/null | sed -n 's/.*"selector": *"\([^"]*\)".*/\1/p')
  compgen -W "auto cpu gpu all $found" -- "$2"
}

_aerostat_outputs() {
  case $1 in
    export) _aerostat_files "$2" ply obj glb gltf ;;
    artwork) _aerostat_files "$2" svg ;;
    contact-sheet) _aerostat_files "$2" png ;;
    film) _aerostat_files "$2" mp4 mov mkv webm ;;
    new) _aerostat_files "$2" json ;;
    *) _aerostat_files "$2" png exr ;;
  esac
}

_aerostat_values() {
  local program=$1 command=$2 option=$3 word=$4 IFS=$' \t\n'
  case $option in
    --device) _aerostat_devices "$program" "$word" ;;
    --quality) compgen -W 'draft standard final' -- "$word" ;;
    --lanes) compgen -W '1 4 8 16' -- "$word" ;;
    --format) compgen -W "$([[ $command == export ]] && echo ply obj glb gltf || echo png exr tif)" -- "$word" ;;
    --codec) compgen -W 'h264 av1 prores lossless' -- "$word" ;;
    --plants) compgen -W 'none seen all' -- "$word" ;;
    --labels) _aerostat_files "$word" geojson json csv ;;
    --labels-json) _aerostat_files "$word" json ;;
    --checkpoint) _aerostat_files "$word" checkpoint ;;
    -o | --output) _aerostat_outputs "$command" "$word" ;;
    --set | --width | --height | --spp | --seed | --seeds | --crop | --memory-limit | --columns | --view | --views | \
      --tile-width | --most-triangles | --balloon | --frames | --shard | --time-limit | --checkpoint-every) ;;
    *) return 1 ;;
  esac
}

_aerostat() {
  local line=${COMP_LINE:0:COMP_POINT} program=${COMP_WORDS[0]} command='' word previous i
  # The line is split at spaces only. Bash also splits words at ':' and '=', which selectors of devices
  # and values of --set contain.
  local -a words
  read -r -a words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=('')
  word=${words[-1]}
  previous=${words[-2]-}
  for ((i = 1; i < ${#words[@]} - 1; ++i)); do
    [[ " $_aerostat_commands " == *" ${words[i]} "* ]] && command=${words[i]} && break
  done
  local IFS=$'\n'
  if [[ $word == --*=* ]]; then
    previous=${word%%=*}
    word=${word#*=}
  fi
  if ! COMPREPLY=($(_aerostat_values "$program" "$command" "$previous" "$word")); then
    if [[ $word == -* ]]; then
      COMPREPLY=($(IFS=' ' compgen -W "$(_aerostat_options "$command")" -- "$word"))
    elif [[ -z $command ]]; then
      COMPREPLY=($(IFS=' ' compgen -W "$_aerostat_commands" -- "$word"))
    elif [[ $command == merge ]]; then
      COMPREPLY=($(_aerostat_files "$word" exr))
    elif [[ $command != scenes && $command != devices ]]; then
      COMPREPLY=($(_aerostat_scenes "$program" "$word"))
    fi
  fi
  # Bash regards the text before the last ':' as an earlier word, which must not be repeated.
  if [[ $word == *:* && $COMP_WORDBREAKS == *:* ]]; then
    COMPREPLY=("${COMPREPLY[@]#"${word%:*}:"}")
  fi
}

complete -o filenames -o nosort -F _aerostat aerostat
