# Short names for the usual commands. CMakePresets.json is underneath.
.POSIX:
.PHONY: help build demo test bench web docs validation study soak asan tsan fuzz format tidy

DEMO_CASE = runs/yohutagawa-case
DEMO_RUN = runs/yohutagawa
# Long runs; the sanitizers make them ten times longer and find nothing new in them. Those that
# CMake calls long are not built. The pages in a browser, labelled web, take minutes as well.
LONG_TESTS = _NOT_BUILT$$|^verify[.](All|Mutations)|^tutorial$$|^faults|^app[.](BenchCommand[.]WritesJson|VerifyCommand[.]LeavesPage)

help:
	@echo 'make build    install what is missing, then build build/release/src/sabo'
	@echo 'make demo     build, then run the example: a debris flow meets a check dam'
	@echo 'make test     build, then run all checks and tests'
	@echo 'make bench    measure the speed on this machine: the program, then its parts'
	@echo 'make web      rebuild the pages of web/, which the program holds (npm)'
	@echo 'make docs     rewrite the keys in docs/ from their descriptions, and the figures of the laws'
	@echo 'make validation  hours: run all cases with a known outcome (or CASES), rewrite docs/validation.md'
	@echo 'make study    hours: run the example in all variants, rewrite the table of docs/yohutagawa.md'
	@echo 'make soak     an hour (SOAK_MINUTES): kill runs, let them go on, compare their results'
	@echo 'make asan     the quick tests under the address and undefined-behaviour sanitizers'
	@echo 'make tsan     the solver and its backends under the thread sanitizer'
	@echo 'make fuzz     each reader of files against FUZZ_SECONDS of inputs made up (60)'
	@echo 'make format   format src/ and tests/'
	@echo 'make tidy     static analysis of src/ by clang-tidy'

build:
	@sh tools/install_packages.sh
	cmake --preset release
	cmake --build --preset release

demo: build
	@mkdir -p runs
	test -d $(DEMO_CASE) || build/release/src/sabo new yohutagawa $(DEMO_CASE)
	build/release/src/sabo run $(DEMO_CASE) -o $(DEMO_RUN) --overwrite --spacing 1.5 --duration 120
	build/release/src/sabo plot $(DEMO_RUN) --times 10,30,60,120
	build/release/src/sabo report $(DEMO_RUN)
	@echo 'Open $(DEMO_RUN)/index.html and report.html beside it in a browser.'

test: build
	python3 tools/check_layers.py
	sh tools/check_format.sh
	python3 tests/tools/test_check_layers.py
	python3 tests/tools/test_compare_bench.py
	ctest --preset release -j 2

bench: build
	build/release/src/sabo bench
	build/release/tests/microbench/microbench

# Results of this build are used again, so it goes on where it stopped. Those of other cases stay on
# the page, with their versions: CASES="jet spheric2" runs these two only.
CASES = --all
validation: build
	mkdir -p build/validation docs/validation
	cp -u docs/validation/*.* build/validation
	build/release/src/sabo verify $(CASES) -o build/validation || test $$? -eq 3
	rm -f docs/validation/*.*
	cp build/validation/*-full*.toml build/validation/*-full*.svg docs/validation
	sed 's|](\./|](validation/|' build/validation/validation.md > docs/validation.md

web:
	@sh tools/install_packages.sh
	sh tools/build_web.sh

docs:
	@sh tools/install_packages.sh
	cmake --preset release
	cmake --build --preset release --target test_case_file sabo
	SABO_UPDATE_DOCS=1 build/release/tests/test_case_file --gtest_filter='Documents.*'
	build/release/src/sabo models --plot -o docs/images

study: build
	python3 tools/yohutagawa_study.py

SOAK_MINUTES = 60
soak: build
	sh tests/faults/faults.sh "$$PWD/build/release/src/sabo" 50 $(SOAK_MINUTES)

asan:
	@sh tools/install_packages.sh
	cmake --preset asan
	cmake --build --preset asan --target quick_tests
	ctest --preset asan -j 2 -E '$(LONG_TESTS)' -LE web

# The tests of what runs on threads, most of them at several numbers of these.
tsan:
	@sh tools/install_packages.sh
	cmake --preset tsan
	cmake --build --preset tsan --target test_base test_backend test_solver
	ctest --preset tsan -j 2 -R 'Threads|^base[.](Background|HostLoops)'

FUZZ_SECONDS = 60
fuzz:
	@sh tools/install_packages.sh
	cmake --preset asan
	cmake --build --preset asan --target fuzz_targets
	sh tests/fuzz/run.sh build/asan/tests/fuzz $(FUZZ_SECONDS) build/fuzz

format:
	@sh tools/install_packages.sh
	sh tools/check_format.sh --fix

tidy:
	@sh tools/install_packages.sh
	cmake --preset dev
	run-clang-tidy-14 -quiet -p build/dev '/src/.*[.]cpp$$'
