// SPDX-License-Identifier: MIT

// Does nothing. The build compiles the headers that all tests share once, as part of this program.
int main() {}
