#!/usr/bin/env bash
# One picture of many, to look at: every mesh (a row) in every strip (a column) by one method.
#   contact_sheet.sh OUT.png METHOD [MESH or STRIP...]
# Without meshes or strips the demo's are taken. SIDE=400 sets the side of each picture, BUILD the build folder,
# FLAGS what else `chiaro render` is told.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program="${BUILD:-$tools/../../build/release}/bin/chiaro"
demo=$tools/../../resources/demo
side=${SIDE:-400}
[ $# -ge 2 ] || { sed -n '2,5s/^# *//p' "$0"; exit 2; }
sheet=$1 method=$2
shift 2
meshes=() strips=()
for file in "$@"; do
    case "${file,,}" in
        *.obj | *.ply | *.off | *.stl | *.glb | *.gltf) meshes+=("$file") ;;
        *) strips+=("$file") ;;
    esac
done
[ ${#meshes[@]} -gt 0 ] || meshes=("$demo"/meshes/*.{glb,obj,ply})
[ ${#strips[@]} -gt 0 ] || strips=("$demo"/samples/*.png)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
pictures=()
for mesh in "${meshes[@]}"; do
    for strip in "${strips[@]}"; do
        picture=$folder/$(printf '%04d' ${#pictures[@]}).png
        # shellcheck disable=SC2086 # several flags
        "$program" render --mesh "$mesh" --sample "$strip" --method "$method" --size "${side}x$side" ${FLAGS:-} \
            -o "$picture" --quiet
        pictures+=("$picture")
    done
done
oiiotool "${pictures[@]}" --mosaic:pad=4 "${#strips[@]}x${#meshes[@]}" -o "$sheet"
