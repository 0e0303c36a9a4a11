#!/usr/bin/env bash
# Builds these pages as a site in build/site, with MkDocs and its Material theme; a dead link fails.
# Installs what is missing (Debian, root or sudo). From the project's root or anywhere else:
#   bash docs/site.sh            then python3 -m http.server --directory build/site
# (opened as a file, all but the search works).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
packages=(mkdocs mkdocs-material python3-nbconvert libjs-katex)
if ! dpkg -s "${packages[@]}" > /dev/null 2>&1; then
  sudo=$([ "$(id -u)" -eq 0 ] || echo "sudo -n")
  $sudo apt-get install -y --no-install-recommends "${packages[@]}" > /dev/null ||
    { echo "site: install ${packages[*]}" >&2; exit 2; }
fi
mkdir -p build
rm -rf build/site_pages build/site
/usr/bin/python3 docs/site/pages.py "$root" build/site_pages
cp docs/site/mkdocs.yml build/mkdocs.yml
/usr/bin/mkdocs build --strict --quiet --config-file build/mkdocs.yml
echo "build/site/index.html is written"
