#include <cromer/c.h>
#include <stdio.h>

double t[1200], y[1200];
size_t n = 1200;

void reader(void) {
// here
}
