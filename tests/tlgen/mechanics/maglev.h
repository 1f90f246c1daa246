/* Magnetic levitation: a coil that lifts a ball, its charge as a coordinate. */
#ifndef MAGLEV_H
#define MAGLEV_H

typedef struct coil_tag {
	float	l_far;		/* inductance without ball, H; exact in single precision */
	float	l_gap;		/* what the ball adds at contact, H */
	double	gap;		/* at which that has halved, m */
	double	resistance;	/* ohm */
	double	capacitance;	/* F */
} coil;

extern double	coil_inductance(const coil *, double);
extern double	coil_voltage(double);

#endif
