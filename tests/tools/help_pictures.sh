#!/usr/bin/env bash
# Makes the pictures of the help's pages again with the studio itself: help_pictures.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
studio="${1:-build/release}/bin/chiaro-studio"
pictures=resources/help/pictures
mkdir -p $pictures
# A dock is as large as the window leaves it: tall ones at the sides, wide ones below.
for dock in sample scene parameters gradient view-planning; do
    tests/support/with_display "$studio" --language en --theme dark --size 1400x1160 --dock $dock --screenshot $pictures/$dock.png
done
for dock in timeline metric-graph jobs history; do
    tests/support/with_display "$studio" --language en --theme dark --size 900x900 --dock $dock --screenshot $pictures/$dock.png
done
