/* Must not compile where warnings are errors: a float becomes a double unasked. */
double twice(float x, double y);
double twice(float x, double y) { return x * y; }
int main(void) { return (int)twice(1.0F, 0.0); }
