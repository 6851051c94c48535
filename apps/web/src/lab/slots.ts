/**
 * What a feature puts into a session for other features to draw, by name. The feature declares its type here
 * (`declare module './slots.ts'`): who draws it knows what it is, and not whose.
 */
// eslint-disable-next-line @typescript-eslint/no-empty-object-type -- features add to it
export interface Slots {}
