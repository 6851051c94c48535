import { m, message } from '#words/message.ts'
import type { Facts } from '@botgarten/blocks'

/** The name without what says that it is a copy, in the language of now. */
function original(name: string): string {
  const plain = m['session.copy']({ name: '' })
  const [before, after] = m['session.copyNumber']({ name: '', number: '#' }).split('#') as [string, string]
  const counted = name.endsWith(after)
    ? /^(.*?)\d+$/.exec(name.slice(0, name.length - after.length))?.[1]
    : undefined
  if (counted?.endsWith(before)) return counted.slice(0, -before.length)
  return name.endsWith(plain) ? name.slice(0, -plain.length) : name
}

/** A name for a copy that nothing else has: "Fear (copy)", then "Fear (copy 2)"; never a copy of a copy. */
export function nameOfCopy(name: string, taken: readonly string[]): string {
  const own = original(name)
  const names = new Set([name, ...taken])
  let copy = m['session.copy']({ name: own })
  for (let number = 2; names.has(copy); number += 1) copy = m['session.copyNumber']({ name: own, number })
  return copy
}

/** A refusal in a child's words. */
export const wordsOfRefusal = (problem: string, facts: Facts = {}) => ({
  title: message(`problem.${problem}.title`, facts),
  text: message(`problem.${problem}.text`, facts),
})
