/** By group: colour of flag and dots, a tint for its area, a shade for words on that tint. */
export const groupLooks = [
  { colour: '#E4604A', tint: '#FBE0DA', text: '#8E2A12' },
  { colour: '#1E8A83', tint: '#D8EFEA', text: '#0F635E' },
  { colour: '#D99A12', tint: '#FBE9C0', text: '#6E4A00' },
  { colour: '#6F55C4', tint: '#E6E0F7', text: '#4A3494' },
  { colour: '#2C6FB0', tint: '#DCE9F6', text: '#1D4E80' },
  { colour: '#7B5B45', tint: '#EBDFD5', text: '#553B29' },
] as const

/** Outline of a dot of radius r round 0, 0: a form of its own for each group, so that colour is not all. */
const forms: readonly ((r: number) => string)[] = [
  (r) => `M${r} 0A${r} ${r} 0 1 1 ${-r} 0A${r} ${r} 0 1 1 ${r} 0Z`,
  (r) => `M${-r * 0.9} ${-r * 0.9}H${r * 0.9}V${r * 0.9}H${-r * 0.9}Z`,
  (r) => `M0 ${-r * 1.2}L${r * 1.1} ${r * 0.8}H${-r * 1.1}Z`,
  (r) => `M0 ${-r * 1.3}L${r * 1.3} 0L0 ${r * 1.3}L${-r * 1.3} 0Z`,
  (r) => `M0 ${r * 1.2}L${r * 1.1} ${-r * 0.8}H${-r * 1.1}Z`,
  (r) =>
    `M${-r * 1.2} ${-r * 0.45}H${-r * 0.45}V${-r * 1.2}H${r * 0.45}V${-r * 0.45}H${r * 1.2}V${r * 0.45}H${r * 0.45}V${r * 1.2}H${-r * 0.45}V${r * 0.45}H${-r * 1.2}Z`,
]

/** Form of a group's dots; −1: in no group yet. */
export const formOf = (group: number, radius: number): string => (forms[group] ?? forms[0]!)(radius)
