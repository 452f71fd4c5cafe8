#!/usr/bin/env bash
# translations.sh update|check LUPDATE CORE_TEXTS
# update: brings resources/translations/*.ts up to the source; what is new stands there as unfinished.
# check: fails, naming them, when texts of the studio are missing there or not translated yet.
# LUPDATE is Qt's; CORE_TEXTS the program that lists core's texts.
set -euo pipefail
mode=$1 lupdate=$2 core_texts=$3
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for table in $(grep -rhoE 'static const ParameterTable<[A-Za-z]+>& table\(\)' core | sed -E 's/.*<(.*)>.*/\1/'); do
    grep -qE "addTable<([a-z]+::)?$table>" tests/tools/core_texts.cpp && continue
    echo "tests/tools/core_texts.cpp: the table of $table is missing; its texts can't be translated"
    exit 1
done
"$core_texts" > "$work/core_texts.cpp"

status=0
for translation in resources/translations/*.ts; do
    copy=$work/$(basename "$translation")
    cp "$translation" "$copy"
    "$lupdate" -silent -locations none -no-obsolete -I . "$work/core_texts.cpp" app widgets core -ts "$copy" 2> "$work/log" ||
        { cat "$work/log"; exit 1; }
    # A tr() that lupdate can't place would never be looked at.
    if grep -E "lacks Q_OBJECT|cannot be called without context" "$work/log"; then status=1; fi
    count=$(grep -c '<source>' "$copy")
    unfinished=$(grep -c 'type="unfinished"' "$copy" || true)
    echo "$translation: $count texts, $unfinished not translated"
    if [ "$mode" = update ]; then
        cp "$copy" "$translation"
    elif [ "$unfinished" -gt 0 ]; then
        grep -B 4 'type="unfinished"' "$copy" | grep '<source>'
        status=1
    fi
    [ "$count" -ge 400 ] || { echo "only $count texts were found: is the list of folders right?"; status=1; }
done
exit $status
