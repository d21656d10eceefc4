#!/usr/bin/env bash
# Gradescope runs this once, as root, when it makes the image: it builds raylab and draws the hidden cameras.
# The archive that you upload holds this file, run_autograder, and raylab's sources in the folder raylab:
#   git archive --prefix=raylab/ HEAD | tar x -C upload && cp course/gradescope/* upload && (cd upload && zip -qr ../autograder.zip .)
# A grading.toml of your own goes beside this file.
set -euo pipefail
cd /autograder/source
apt-get update -qq && apt-get install -y -qq --no-install-recommends bubblewrap
export XDG_CACHE_HOME=/autograder/cache
raylab/raylab doctor
config=(); [[ -e grading.toml ]] && config=(--config grading.toml)
# An empty submission: what is left are the references of the hidden cameras, and the precompiled header.
mkdir -p /autograder/empty/nobody
raylab/raylab grade /autograder/empty --out /autograder/graded "${config[@]}"
