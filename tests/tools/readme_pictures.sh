#!/usr/bin/env bash
# Makes the README's pictures again with the program itself: readme_pictures.sh [BUILD_FOLDER]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
programs="${1:-build/release}/bin"
demo=resources/demo
paint=$demo/samples
pictures=resources/pictures

"$programs/chiaro" render $demo/demo.chiaro --size 800x800 -o $pictures/skull.jpg
"$programs/chiaro" render --mesh $demo/meshes/still_life.obj --sample $paint/oil.png \
    --object cloth=$paint/watercolour.png --object bottle=$paint/watercolour.png --object jug=$paint/impasto.png \
    --object bowl=$paint/charcoal.png --object pear=$paint/pastel.png --object table=$paint/hatching.png \
    --light -0.7,0.6,0.45 --camera 12,16,1 --size 800x800 -o $pictures/still_life.jpg
tests/support/with_display "$programs/chiaro-studio" --language en --theme dark --screenshot $pictures/studio.png
