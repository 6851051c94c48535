/** How a robot came to its brain: lanes of a race. */
export const laneKinds = ['hand', 'examples', 'trying', 'ifThen'] as const
export type LaneKind = (typeof laneKinds)[number]
