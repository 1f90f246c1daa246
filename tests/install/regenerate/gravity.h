/* Acceleration of free fall, m/s^2. */
#define GRAVITY 9.5
