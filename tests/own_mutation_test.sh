#!/usr/bin/env bash
# The proof of docs/own-mutation.md: in a copy of the program, the example becomes a mutation of the
# catalogue by one file, one include and one name; `wander check` passes.  Then a line of its
# density is forgotten, and `wander check` fails with exit code 4.
#   tests/own_mutation_test.sh FOLDER [CMAKE_OPTION...]      builds in FOLDER, a minute or several
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
folder=$1
shift
copy=$folder/source build=$folder/build
check=("$build/bin/wander" check gallery:article-1 --mutations 'bidirectional=1,sensor_slide=1' --samples 50k -q)

rm -rf "$copy"
mkdir -p "$copy"
cp -a "$source"/{CMakeLists.txt,LICENSE,CITATION.cff,statistics,work,core,mlt,mutations,scenes,schema,records,lab,draw,tools} "$copy"
cp "$source/docs/examples/sensor_slide.h" "$copy/mutations/"
sed -i -e 's|^#include "mutations/primary_small.h"$|&\n#include "mutations/sensor_slide.h"|' \
       -e 's|PrimaryLarge>;$|PrimaryLarge, SensorSlide>;|' "$copy/mutations/catalogue.h"
cmake -S "$copy" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DWANDER_TESTS=OFF \
      -DWANDER_BENCHMARKS=OFF "$@" >/dev/null

echo "== As it is shown"
cmake --build "$build" --target wander >/dev/null
"${check[@]}"

echo "== Without the size of the window"
sed -i '/density \/= window_of/d' "$copy/mutations/sensor_slide.h"
cmake --build "$build" --target wander >/dev/null
status=0
"${check[@]}" || status=$?
[ "$status" -eq 4 ] || { echo "the forgotten factor was not caught: exit code $status" >&2; exit 1; }
