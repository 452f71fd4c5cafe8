#!/bin/sh
# Makes the relightable page: build.sh FOLDER SHADERS OUTPUT, where npm may put things into FOLDER. Where its
# libraries can't be had, says so and succeeds: the rest of Chiaro does without.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$1 shaders=$2 output=$3

left_out() {
    echo "The relightable page is left out: $1." >&2
    rm -f "$output"
    exit 0
}

command -v npm > /dev/null && command -v node > /dev/null || left_out "npm is not installed"
mkdir -p "$folder"
if ! cmp -s "$here/package-lock.json" "$folder/installed-lock.json"; then
    cp "$here/package.json" "$here/package-lock.json" "$folder"
    npm ci --prefix "$folder" --ignore-scripts --no-audit --no-fund --loglevel error \
        --fetch-retries 0 --fetch-timeout 60000 > "$folder/npm.log" 2>&1 ||
        left_out "three.js could not be had from npm ($folder/npm.log says why)"
    cp "$here/package-lock.json" "$folder/installed-lock.json"
fi
node "$here/build.mjs" "$folder/node_modules" "$shaders" "$output"
