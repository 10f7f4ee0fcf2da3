#!/usr/bin/env bash
# Installs the Debian packages that tramline needs, and only those that are missing.
# Usage: install-packages.sh [program] [build] [layout] [test] [qgis] [lint]     (default: program build)
set -euo pipefail

program_packages=(
  build-essential binutils g++ cmake ninja-build ccache pkg-config
  libgdal-dev libgeos-dev libproj-dev proj-data libcairo2-dev libtbb-dev coinor-libclp-dev zlib1g-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libpugixml-dev libtomlplusplus-dev
  fonts-dejavu-core
)
# The rest of what is built: server, page, Python package, tests and benchmarks.
build_packages=(
  libcpp-httplib-dev pybind11-dev python3-dev
  libgtest-dev libbenchmark-dev libompl-dev coinor-libcbc-dev
  gdal-bin python3 sqlite3 zip
)
# The page is built by these commands. Looked for as commands: a node from elsewhere brings its own npm, and does not
# bear Debian's beside it.
command -v node >/dev/null || build_packages+=(nodejs)
command -v npm >/dev/null || build_packages+=(npm)
# Peers that only tests talk to; gpsfake is one of the clients. Chromium drives the page, the others read routes and cards.
test_packages=(gpsd gpsd-clients chromium gpsbabel poppler-utils python3-yaml python3-jsonschema)
# The Python package is tested with what its users have beside it.
test_packages+=(python3-pytest python3-hypothesis python3-geopandas python3-shapely python3-matplotlib python3-distributed mypy)
# The plugin for QGIS is tested in QGIS by a long test alone: it is large.
qgis_packages=(qgis python3-qgis)
# What `make layout` and `make format` need: the quick part of `make lint`.
layout_packages=(clang-format-14 shellcheck)
# What `make lint` and the long tests need besides.
lint_packages=(clang libclang-rt-14-dev clang-tidy)

wanted=()
(($# > 0)) || set -- program build
for list in "$@"; do
  case "$list" in
    program) wanted+=("${program_packages[@]}") ;;
    build) wanted+=("${build_packages[@]}") ;;
    layout) wanted+=("${layout_packages[@]}") ;;
    test) wanted+=("${test_packages[@]}") ;;
    qgis) wanted+=("${qgis_packages[@]}") ;;
    lint) wanted+=("${layout_packages[@]}" "${lint_packages[@]}") ;;
    *)
      echo "install-packages.sh: no list named '$list' (there are: program, build, layout, test, qgis, lint)" >&2
      exit 2
      ;;
  esac
done

if ! command -v apt-get >/dev/null; then
  echo "install-packages.sh: no apt-get here; make sure these are installed: ${wanted[*]}" >&2
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
((${#missing[@]} == 0)) && exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install-packages.sh: as root, run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -q --no-install-recommends "${missing[@]}"
