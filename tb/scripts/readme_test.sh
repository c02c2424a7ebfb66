#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# readme_test.sh ROOT BUILD: runs the commands of README.md, of docs/scenes.md and of the help of each verb, in a folder of their own beside a
# link to the build. The commands of README that it does not run stand here with the reason.
set -euo pipefail
root=$(readlink -f "$1") build=$(readlink -f "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$build" build
ln -s "$root/docs" docs
ln -s "$root/scripts" scripts
fail() { echo "$*" >&2 && exit 1; }

# run COMMAND: succeeds and says something, on standard output or into a file.
run() {
  # A film takes a program that scripts/setup does not install.
  if [[ $1 == *' --film '* ]] && ! command -v ffmpeg >/dev/null; then
    echo "no ffmpeg, not run: $1"
    return
  fi
  echo "+ $1"
  bash -e -o pipefail -c "$1" >said 2>error || { cat said error >&2 && fail "failed: $1"; }
  [ -s said ] || fail "said nothing: $1"
}

count=0
while IFS= read -r command; do
  command=${command%%  #*}
  case $command in
    'scripts/test '* | scripts/test | 'cmake '*) continue ;; # what runs this test, and the build
    'scripts/wave '* | scripts/wave) continue ;;             # a viewer
    'env SYSTEMC_HOME='*) continue ;;                        # build.outside runs it
    'scripts/run '* | scripts/run)
      [ -x "$root/scripts/run" ] || fail 'no scripts/run'
      # what scripts/run starts, in a smaller size
      run 'build/bin/blysk render sphere --engine systemc --watch highlight --size 32x32 --output sphere.png --vcd sphere.vcd'
      ;;
    *) run "$command" ;;
  esac
  count=$((count + 1))
done < <(sed -n 's/^    \([a-z].*\)/\1/p' "$root/README.md" "$root/docs/scenes.md")
[ "$count" -ge 5 ] || fail "README.md has $count commands, expected 5"

# What the commands leave in a clone of the tree, git does not name.
if git -C "$root" rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  shopt -s dotglob
  for made in *; do
    case $made in build | docs | scripts | said | error) continue ;; esac
    [ ! -d "$made" ] || made+=/
    git -C "$root" check-ignore -q --no-index "$made" || fail "$made would be a new file of the tree"
  done
fi

# Below "Examples:" of a verb's help each line is a command.
verbs=$(build/bin/blysk --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p')
[ -n "$verbs" ] || fail 'blysk --help names no verb'
printf 'n,cos\n10,0.9\n' >points.csv
printf '001 100 ff ff ff ff00 ff00 ff00\n' >answers.txt
printf 'n,cos,r,g,b\n10,0.99,200,100,50\n' >in.csv
for verb in $verbs; do
  examples=$(build/bin/blysk "$verb" --help | sed -n '/^Examples:/,$s/^  *\(blysk .*\)/\1/p')
  [ -n "$examples" ] || fail "blysk $verb --help ends without examples"
  while IFS= read -r command; do run "build/bin/$command"; done <<<"$examples"
done
