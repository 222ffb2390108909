// SPDX-License-Identifier: MIT
// Compiles only with the parent's own flag and language level.
#if !defined(PARENTS_OWN_FLAG)
#error "the parent's flags were lost"
#endif
#if __cplusplus != 201703L
#error "the parent's language level was changed"
#endif

int main()
{
    return 0;
}
