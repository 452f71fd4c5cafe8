#include "app/cli/command_line.h"

int main(int argc, char** argv) {
    return chiaro::cli::run(argc, argv);
}
