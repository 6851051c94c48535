/** Fields of a sensor's block: from LOW on it is in the middle, from HIGH on far. */
export type EdgeField = 'LOW' | 'HIGH'

/** Edges of distances and light: cm, or percent. */
const bounds = { least: 1, most: 99 } as const

/** Both edges of a sensor; null where there is only one, because both are the same. */
export type Edges = readonly [low: number, high: number]

/** Where an edge may go without passing the other one. */
export const roomOf = (
  field: EdgeField,
  [low, high]: Edges,
): { readonly least: number; readonly most: number } =>
  field === 'LOW' ? { least: bounds.least, most: high - 1 } : { least: low + 1, most: bounds.most }

/** A whole number where the edge may stand. */
export function edgeAt(field: EdgeField, edges: Edges, wanted: number): number {
  const { least, most } = roomOf(field, edges)
  return Math.min(most, Math.max(least, Math.round(wanted)))
}

/** Where a key puts an edge; null: the key is not for it. */
export function edgeByKey(field: EdgeField, edges: Edges, key: string): number | null {
  const now = field === 'LOW' ? edges[0] : edges[1]
  const { least, most } = roomOf(field, edges)
  const places: { readonly [key: string]: number } = {
    ...{ ArrowRight: now + 1, ArrowUp: now + 1, ArrowLeft: now - 1, ArrowDown: now - 1 },
    ...{ PageUp: now + 10, PageDown: now - 10, Home: least, End: most },
  }
  return Object.hasOwn(places, key) ? edgeAt(field, edges, places[key]!) : null
}
