# What the project needs from Debian 12 and how it gets there; sourced by the commands beside this file.

build_packages=(cmake ninja-build gcc g++ pkg-config clang-19 llvm-19-dev libclang-19-dev liblapacke-dev libopenblas-dev
  libsundials-dev libcmocka-dev libmpfr-dev gnuplot-nox)
report_packages=(python3 python3-venv)
check_packages=(chromium clang-format-19 dpkg-dev git make python3 strace python3-mpmath valgrind
  gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm cppcheck)

# missing_packages NAME..: those that are not installed, one a line.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || echo "$name"
  done
}

# need_packages NAME..: installs what is missing, or says what to install and returns 1. Touches nothing where all is there.
need_packages() {
  local missing as_root=()
  if ! command -v dpkg-query >/dev/null; then
    echo "Not a Debian system: going on with what is here. On Debian 12 these packages serve: $*" >&2
    return 0
  fi
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    # A password can be asked for at a terminal only.
    if ! command -v sudo >/dev/null || { ! [ -t 0 ] && ! sudo -n true 2>/dev/null; }; then
      printf 'Some packages are missing. Install them as root, then run this again:\n\n  apt-get install --no-install-recommends %s\n\n' \
        "${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq -o Dpkg::Use-Pty=0 \
    --no-install-recommends "${missing[@]}" </dev/null >/dev/null
}
