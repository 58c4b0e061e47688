#!/usr/bin/env bash
# Makes one site of the documentation: site.sh, to target/site/book, which opens from disk without a network.
#
# It needs mdBook: $MDBOOK, or mdbook in the PATH, or else the version below, which cargo builds into target/mdbook, once and for
# about a minute and a half of a processor. The pages of the root are taken along, with their links turned to where the pages are in
# the site.
set -euo pipefail
cd "$(dirname "$0")/.."
version=0.5.4

mdbook=${MDBOOK:-$(command -v mdbook || true)}
if [ -z "$mdbook" ]; then
    mdbook=$PWD/target/mdbook/bin/mdbook
    # Not optimised, it is built in half the time, and still takes a second for all pages.
    [ -x "$mdbook" ] || CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 \
        cargo install --quiet mdbook --version "$version" --locked --no-default-features --root target/mdbook
fi

site=target/site
rm -rf "$site"
mkdir -p "$site/src/tools/assets"
cp -r docs/. "$site/src"
mv "$site/src/book.toml" "$site"
rm "$site/src/"*.sh "$site/src/"*.py
cp README.md ARCHITECTURE.md DETERMINISM.md CONTRIBUTING.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE CITATION.cff "$site/src"
cp tools/assets/LiberationSans-LICENSE "$site/src/tools/assets"
find "$site/src" -maxdepth 1 -name '*.md' -exec sed -i 's#](docs/#](#g; s#](\.\./#](#g' {} +
# mdBook calls pages by their files, but for those called README.
mv "$site/src/sweeps/README.md" "$site/src/sweeps/index.md"
sed -i 's#](sweeps/README\.md)#](sweeps/index.md)#; s#](SUMMARY\.md)#](toc.html)#' "$site/src/"*.md
# Tables as wide as the window.
printf ':root { --content-max-width: 1100px; }\n' >"$site/wide.css"
"$mdbook" build "$site"

# What the pages load has to be in the site.
if grep -rnoE '<(script|img|link)[^>]*(src|href)="https?:[^"]*"' "$site/book" --include='*.html' | grep -v 'rel="canonical"'; then
    echo "the site loads what is not in it" >&2
    exit 1
fi
python3 docs/links.py "$site/book"
printf 'written: %s/book/index.html\n' "$site"
