#!/bin/bash -eu
# Every target with its seeds and the dictionary, where ClusterFuzzLite and OSS-Fuzz look for them.
cargo fuzz build -O --debug-assertions
for target in $(cargo fuzz list); do
    cp "fuzz/target/x86_64-unknown-linux-gnu/release/$target" "$OUT/"
    cp fuzz/hard.dict "$OUT/$target.dict"
    zip -jqr "$OUT/${target}_seed_corpus.zip" "fuzz/corpus/$target"
done
