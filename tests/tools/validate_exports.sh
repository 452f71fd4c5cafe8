#!/usr/bin/env bash
# Exports the demo scene and every real mesh as GLB and has each validated.
# validate_exports.sh CHIARO MODULE_FOLDER RESOURCES DATA; 77 (skipped) without the validator
set -euo pipefail
chiaro=$1 modules=$2 resources=$3 data=$4
if ! command -v node > /dev/null || [ ! -d "$modules/gltf-validator" ]; then
    echo "no gltf-validator in $modules: ./dev test installs it where there is npm"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CACHE_HOME=$folder/cache
quick=(--view-count 6 --view-size 96 --level-count 2 --level-size 64 --quiet)
for method in image-based view-aligned view-dependent; do
    "$chiaro" export "$resources/demo/demo.chiaro" --method "$method" -o "$folder/demo_$method.glb" "${quick[@]}" --atlas 512
done
"$chiaro" export "$resources/demo/demo.chiaro" --bake texture -o "$folder/demo_texture.glb" "${quick[@]}" --atlas 512
number=0
if [ -d "$data/meshes" ]; then
    while IFS= read -r -d '' mesh; do
        number=$((number + 1))
        "$chiaro" export --mesh "$mesh" --sample "$resources/demo/samples/oil.png" -o "$folder/$number.glb" \
            "${quick[@]}" --atlas 1024
    done < <(find "$data/meshes" -type f -print0 | sort -z)
fi
node "$(dirname "$0")/validate_glb.js" "$modules" "$folder"/*.glb
