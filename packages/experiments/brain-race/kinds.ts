/** How a robot came to its brain. */
export const laneKinds = ['hand', 'examples', 'trying', 'ifThen'] as const
export type LaneKind = (typeof laneKinds)[number]
