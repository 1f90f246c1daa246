// tlgen: rewrites plain C Lagrangians as functions on truncated Taylor series.
#include "Generate.h"

int main(int argc, char **argv) {
  tlgen::Run run;
  switch (tlgen::parseOptions(argc, argv, run)) {
  case tlgen::Command::Generate:
    return tlgen::generate(run);
  case tlgen::Command::Done:
    return 0;
  case tlgen::Command::Fail:
    break;
  }
  return 2;
}
