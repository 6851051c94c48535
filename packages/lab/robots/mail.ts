import type { Mail } from '@botgarten/blocks'
import type { RobotRun } from './run.ts'

/** No letter box holds more; what comes then is lost. */
const mostLetters = 1000

const plain = (name: string) => name.toLowerCase().replace(/[^\p{L}\p{N}]/gu, '')

/** Messages of one robot to the others of its world. A robot goes by its id, or by its number counted from 1: `Bo 2`, `2`. */
export function mailOf(self: number, robots: () => readonly RobotRun[]): Mail {
  const goesBy = (id: string, index: number) => [plain(id), `bo${index + 1}`, String(index + 1)]
  return {
    find(name) {
      const found = robots().find(
        ({ id }, index) => index !== self && goesBy(id, index).includes(plain(name)),
      )
      return found?.id ?? null
    },
    send(to, letter) {
      const letters = robots().find(({ id }) => id === to)?.thread.letters
      if (letters && letters.length < mostLetters) letters.push({ ...letter, from: robots()[self]!.id })
    },
  }
}
