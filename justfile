# The tasks of Nacreous. Start them with ./just, which brings this runner and uv along.

set script-interpreter := ["sh", "-eu"]

# The clone's own environment comes first, whatever is active in the shell that calls.
export VIRTUAL_ENV := justfile_directory() / ".venv"
export PATH := VIRTUAL_ENV / "bin:" + justfile_directory() / ".tools/bin:" + env("PATH")
export UV_PYTHON_DOWNLOADS := "never"
export NODE_DISABLE_COMPILE_CACHE := "1" # npm would leave one in the temporary folder
unexport CONDA_PREFIX
unexport PYTHONDONTWRITEBYTECODE # tests start hundreds of programs, each of which would compile all it imports
unexport PYTHONHOME
unexport PYTHONPATH
unexport UV_PYTHON
unexport UV_SYSTEM_PYTHON

# The types of the browser's rooms: without them the viewer's light, state and panels are not looked at.
wasm_types := justfile_directory() / "target/wasm/nacreous.d.ts"

# What maturin tells PyO3, told to clippy and cargo test too: build for this interpreter, and as an
# extension, which needs no libpython.
export PYO3_PYTHON := VIRTUAL_ENV / "bin/python"
export PYO3_BUILD_EXTENSION_MODULE := "1"

# Show this help
[group("look")]
help:
    @echo "Call ./just TASK, where TASK is one of:"
    @just --list --unsorted --list-heading ""

# Make pearl.png, the paper's pearl
[group("look")]
pearl: _program
    nacreous render paper -o pearl.png

# Make every figure of the paper, in paper/
[group("look")]
figures: _program
    nacreous paper paper

# Run every test and every check; what fails or is left out is told at the end
[group("trust")]
test:
    tests/every-part check-rust check-python test-rust _viewer test-python _test-wasm _test-pages

# Run the Rust tests, the examples in its documentation included
[group("trust")]
test-rust *options: setup
    tests/own-temporary-folder cargo test --workspace {{ options }}

# Run the Python tests, the examples in docstrings, README, docs and examples/ included
[group("trust")]
test-python *options: setup
    @# Three on two processors, for tests of pages mostly wait; a file's tests stay together, for they share what they made.
    @# Files in their order: the last, of docstrings, are short, and no processor waits for another's long one.
    @# One thread each for NumPy's algebra, whose threads else wait for each other.
    OPENBLAS_NUM_THREADS=1 tests/own-temporary-folder pytest --numprocesses 3 --dist loadfile --no-loadscope-reorder {{ options }}

# Check the pages' types and format, and run the tests that need no server
[group("trust")]
[working-directory("studio")]
test-pages: pages
    npx --no-install tsc --noEmit --project {{ if path_exists(wasm_types) == "true" { "tsconfig.json" } else { "tsconfig.pages.json" } }}
    npx --no-install vitest run
    npx --no-install prettier --check --log-level warn .

# Check format, lint, links, types, the compiled module's stub, and who imports whom
[group("trust")]
check:
    tests/every-part check-rust check-python

# Check the Rust code's format, lint, and links in its documentation
[group("trust")]
[script]
check-rust: _rust-tools setup
    failed=
    cargo fmt --all --check || failed="$failed format"
    cargo clippy --workspace --all-targets -- -D warnings || failed="$failed lint"
    RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --quiet || failed="$failed documentation"
    [ -z "$failed" ] || { echo "Rust:$failed failed" >&2; exit 1; }

# Check the Python code's format, lint, types, the compiled module's stub, and who imports whom
[group("trust")]
[script]
check-python: setup
    failed=
    ruff format --check || failed="$failed format"
    ruff check || failed="$failed lint"
    mypy || failed="$failed types"
    # PyO3 lists every name in __all__; the stub says the same by having them.
    echo nacreous._core.__all__ | stubtest nacreous._core --allowlist /dev/stdin || failed="$failed stub"
    lint-imports --no-logo || failed="$failed imports"
    [ -z "$failed" ] || { echo "Python:$failed failed" >&2; exit 1; }

# Run the tests of optics as on other processors, by Debian's qemu-user and gcc-aarch64-linux-gnu, and the fingerprints by AVX2
[group("trust")]
[script]
test-processors:
    tests="cargo test --release --package nacreous-optics --lib --tests"
    for processor in Nehalem Haswell; do # without and with AVX2; neither has AVX-512
        echo "As on $processor"
        export CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_RUNNER="qemu-x86_64 -cpu $processor"
        $tests --target x86_64-unknown-linux-gnu
    done
    echo "As on AArch64 (rustup target add aarch64-unknown-linux-gnu)"
    CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc \
        CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64 -L /usr/aarch64-linux-gnu" \
        $tests --target aarch64-unknown-linux-gnu
    echo "Pictures by AVX2, without the code for AVX-512"
    copy=$(mktemp -d)
    trap 'rm -rf "$copy"' EXIT
    cp -r Cargo.* crates data tests "$copy"
    sed -i '/x86_64+avx512f/d' "$copy"/crates/optics/src/*.rs
    cargo test --release --manifest-path "$copy/Cargo.toml" --target-dir target/avx2 \
        --package nacreous-render --test fingerprint

# Write the fingerprints of pictures anew, tests/golden/pictures.csv, after a change that is meant
[group("trust")]
fingerprints: setup
    python -m tests.picture.fingerprint

# Measure the speed of the main jobs
[group("trust")]
[script]
bench: setup
    for benchmark in benchmarks/*.py; do python "$benchmark"; done

# Measure the browser's rooms in Node.js, on one thread
[group("trust")]
bench-wasm: _wasm-tools
    cargo xtask wasm
    node benchmarks/optics.mjs
    cargo bench --quiet --package nacreous-render --no-default-features --bench picture > target/picture.csv
    node benchmarks/picture.mjs target/picture.csv

# Prepare .venv with all that tests need, and build the compiled rooms and the pages; at once when nothing changed
[group("build")]
[script]
setup: _environment && _compiled
    packages=$(cksum pyproject.toml requirements.lock | cksum)
    if [ "$packages" != "$(cat .venv/tests-packages 2>/dev/null)" ]; then
        rm -f .venv/built-from # sync removes what the lock does not name, our own package too
        uv pip sync --require-hashes requirements.lock
        echo "$packages" | tee .venv/tests-packages >.venv/program-packages
    fi

# What the program needs, without its tests and their tools: the lock file's versions, by their hashes.
[script]
_program: _environment && _compiled
    packages=$(cksum pyproject.toml requirements.lock | cksum)
    if [ "$packages" != "$(cat .venv/program-packages 2>/dev/null)" ]; then
        uv pip install --constraints requirements.lock --requirements pyproject.toml --group build
        echo "$packages" >.venv/program-packages
    fi

[script]
_environment: _try-pages
    if ! "$PYO3_PYTHON" --version >/dev/null 2>&1; then
        uv venv --clear --relocatable --python .tools/bin/python .venv
    fi

[script]
_compiled:
    sources=$({
        echo "$VIRTUAL_ENV"
        find Cargo.* pyproject.toml crates data -type f -exec cksum {} +
    } | sort | cksum)
    if [ "$sources" != "$(cat .venv/built-from 2>/dev/null)" ]; then
        maturin develop --release --uv
        echo "$sources" >.venv/built-from
    fi

# Build the browser's pages from studio/ into nacreous/server/pages/; at once when nothing changed
[group("build")]
[script]
[working-directory("studio")]
pages: _node-tools
    packages=$(cksum package.json package-lock.json)
    if [ "$packages" != "$(cat node_modules/installed-from 2>/dev/null)" ]; then
        npm ci --no-audit --no-fund
        echo "$packages" >node_modules/installed-from
    fi
    pages=../nacreous/server/pages
    sources=$(find . -path ./node_modules -prune -o -type f -exec cksum {} + | sort | cksum)
    if [ ! -f $pages/index.html ] || [ "$sources" != "$(cat node_modules/built-from 2>/dev/null)" ]; then
        npx --no-install vite build --logLevel warn
        echo "$sources" >node_modules/built-from
    fi

# Build the viewer from studio/ and the browser's rooms into nacreous/viewer/page/; at once when nothing changed
[group("build")]
[script]
[working-directory("studio")]
viewer: _wasm-tools pages
    page=../nacreous/viewer/page
    sources=$({
        find . -path ./node_modules -prune -o -type f -exec cksum {} +
        cksum ../nacreous/card/reasons.json ../nacreous/presets/complete.json
        find ../Cargo.* ../crates ../data ../xtask -path ../xtask/target -prune -o -type f -exec cksum {} +
    } | sort | cksum)
    if [ ! -f $page/index.html ] || [ "$sources" != "$(cat node_modules/viewer-built-from 2>/dev/null)" ]; then
        (cd .. && cargo xtask wasm)
        npx --no-install vite build --config viewer.config.ts --logLevel warn
        echo "$sources" >node_modules/viewer-built-from
    fi

# Make a manylinux wheel with the pages and the viewer, in dist/, and try it on every Python found, 3.11 to 3.14
[group("build")]
[script]
wheel: pages viewer _program
    rm -rf dist
    maturin build --release --compatibility pypi --out dist
    tests/try-wheel dist/*.whl

# Make again what the declarations of keys are copied to: ranges, complete presets, the pages' types
[group("build")]
types: _node-tools setup
    python -m nacreous.spec.ranges >crates/render/src/spec/ranges.csv
    nacreous presets --json >nacreous/presets/complete.json
    nacreous words --json >studio/src/viewer/words/trade.json
    python studio/types/schemas.py | node studio/types/typescript.mjs studio/src

# Build the browser's rooms, WebAssembly, into target/wasm/; lint them, test them in Node.js
[group("build")]
wasm: _rust-tools _wasm-tools setup
    cargo xtask wasm
    python -m tests.wasm.native target/wasm-native
    nacreous presets --json > target/wasm-native/presets.json
    tests/own-temporary-folder node --test --test-reporter=spec tests/wasm/*.test.mjs
    cargo fmt --manifest-path xtask/Cargo.toml --check
    cargo clippy --package nacreous-wasm --package nacreous-wasm-files --target wasm32-unknown-unknown -- -D warnings
    cargo clippy --manifest-path xtask/Cargo.toml --target-dir target/xtask -- -D warnings

# Put all code into the house format, and mend what ruff can mend
[group("build")]
format: setup
    cargo fmt --all
    cargo fmt --manifest-path xtask/Cargo.toml
    ruff check --fix
    ruff format
    if [ -d studio/node_modules ]; then cd studio && npx --no-install prettier --write .; fi

# Make requirements.lock again from pyproject.toml (with --upgrade: the newest of everything)
[group("build")]
lock *options:
    uv pip compile pyproject.toml --group test --all-extras --universal --python-version 3.11 \
        --fork-strategy fewest --generate-hashes --no-header {{ options }} -o requirements.lock

# Remove everything that was built
[group("build")]
clean:
    rm -rf target .venv .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache
    rm -rf nacreous/_core.*.so nacreous/server/pages nacreous/viewer/page studio/node_modules

# Debian's own cargo and rustup's minimal profile come without them.
[script]
_rust-tools:
    for tool in fmt clippy; do
        if ! cargo "$tool" --version >/dev/null 2>&1; then
            echo "cargo $tool is missing, which the checks need:"
            echo "      rustup component add rustfmt clippy   or   sudo apt install rustfmt rust-clippy"
            exit 1
        fi
    done >&2

# Before xtask, which checks too but takes a minute to compile.
[script]
_wasm-tools:
    libraries=$(rustc --print target-libdir --target wasm32-unknown-unknown)
    if [ ! -d "$libraries" ]; then
        echo "Rust's WebAssembly target is missing:   rustup target add wasm32-unknown-unknown"
        exit 2
    elif ! command -v node >/dev/null; then
        echo "Node.js is missing:   sudo apt install nodejs npm"
        exit 2
    fi >&2

# Debian 12's own Node.js is older than Vite needs.
[script]
_node-tools:
    modern='let [major, minor] = process.versions.node.split("."); process.exit(+(major * 100 + +minor < 2019))'
    if ! command -v npm >/dev/null; then
        echo "Node.js is missing, which the study's pages need:   sudo apt install nodejs npm"
        exit 2
    elif ! node -e "$modern"; then
        echo "Node.js $(node --version) is too old for the study's pages: 20.19 or newer, from https://nodejs.org"
        exit 2
    fi >&2

# The pearl does without the pages: no Node.js, or no way to its packages, stops nothing else.
[script]
_try-pages:
    if ! missing=$(just _node-tools 2>&1); then
        echo "$missing" | head -n 1
    elif ! just pages; then
        echo "The study's pages could not be built; all else goes on without."
    fi >&2

[script]
_test-pages:
    if missing=$(just _node-tools 2>&1); then
        just test-pages
    else
        tests/every-part --left-out "the study's pages: $(echo "$missing" | head -n 1)"
    fi

[script]
_viewer:
    if missing=$(just _node-tools 2>&1) && missing=$(just _wasm-tools 2>&1); then
        just viewer
    else
        tests/every-part --left-out "the viewer: $(echo "$missing" | head -n 1)"
    fi

[script]
_test-wasm:
    if missing=$(just _wasm-tools 2>&1); then
        just wasm
    else
        tests/every-part --left-out "WebAssembly: $(echo "$missing" | head -n 1)"
    fi
