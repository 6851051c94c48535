import { m } from '#words/message.ts'

/** A name for the version that the child does not go on with: "Friendship 2", or the first number that is free. */
export function secondName(name: string, taken: readonly string[]): string {
  for (let number = 2; ; number++) {
    const second = m['class.secondName']({ name, number })
    if (!taken.includes(second)) return second
  }
}
