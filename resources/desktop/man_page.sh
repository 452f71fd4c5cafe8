#!/bin/sh
# man_page.sh HELP2MAN OUTPUT VERSION INCLUDED PROGRAM [COMMAND...]
# Writes a manual page from what the program itself says of a command, with the sections that INCLUDED adds.
set -eu
help2man=$1 output=$2 version=$3 included=$4 program=$5
shift 5
LC_ALL=C.UTF-8
export LC_ALL
name=$(basename "$program")
page=$(echo "$name $*" | sed 's/ *$//; s/ /-/g')
# "Paint a mesh (§4)" becomes "paint a mesh"; the studio's first line is its usage.
summary=$("$program" "$@" --help | grep -v '^Usage\|^$' | head -n 1 | sed 's/ *(§[^)]*)//g; s/[.;:].*//; s/^\(.\)/\L\1/')
"$help2man" --no-info --locale C.UTF-8 --name "$summary" --help-option "$* --help" --version-string "$page $version" \
    --include "$included" --source "Chiaro $version" --output "$output.new" "$program"
# help2man takes the command for an argument, and wants a space between two spellings of a flag.
day=$(date -u -d "@${SOURCE_DATE_EPOCH:-$(date +%s)}" +%F)
sed -e "s|^\(\.TH [^ ]* \"1\" \)\"[^\"]*\"|\1\"$day\"|" -e "s|^\.B $name\$|.B $name $*|; s|^\\\\fI\\\\,$* \\\\/\\\\fR||" -e 's/^\\fB\\-h\\fR,\\-\\-help/\\fB\\-h\\fR, \\fB\\-\\-help\\fR/' \
    "$output.new" > "$output"
rm "$output.new"
