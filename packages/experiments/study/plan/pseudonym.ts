/** The letters of Spanish identity numbers: of four digits no wrong one and no two exchanged ones give the same letter. */
const guards = 'TRWAGMYFPDXBNJZSQVHLCKE'

const guardOf = (group: number, child: number) => guards[(group * 100 + child) % guards.length]!

const two = (number: number) => String(number).padStart(2, '0')

/** Of a child: its group and its number in it, each 1 to 99, and a letter that guards against slips: `0207T`. */
export const pseudonymOf = (group: number, child: number): string =>
  `${two(group)}${two(child)}${guardOf(group, child)}`

/** Group and number of a pseudonym as it is typed; null where there is a slip in it. */
export function readPseudonym(typed: string): { readonly group: number; readonly child: number } | null {
  const found = /^(\d\d)(\d\d)([A-Z])$/.exec(typed.replace(/[\s.-]/g, '').toUpperCase())
  if (!found) return null
  const [group, child] = [Number(found[1]), Number(found[2])]
  return group > 0 && child > 0 && guardOf(group, child) === found[3] ? { group, child } : null
}
