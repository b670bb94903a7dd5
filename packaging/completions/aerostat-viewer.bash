# Completion of aerostat-viewer's command line for bash.

_aerostat_viewer() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} found IFS=$' \t\n'
  COMPREPLY=()
  if [[ $previous == --device ]]; then
    found=$(aerostat devices --json 2>/dev/null | sed -n 's/.*"selector": *"\([^"]*\)".*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "auto cpu gpu all $found" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W '--device --help --help-all --version' -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.json' -- "$word")
  fi
}

complete -o filenames -F _aerostat_viewer aerostat-viewer
