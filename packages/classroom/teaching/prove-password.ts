import { triersOfKnown } from '../joining/triers.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'

/**
 * Checks the password of a teacher who is signed in, before something that needs it. Wrong tries of all callers share one count.
 * @throws Refusal 403 for a wrong password, 429 after too many
 */
export async function provePassword(ports: Ports, teacher: string, password: string): Promise<void> {
  const { accounts, limits, secret } = ports
  const guess = limits.guesses.knownSignIns.begin(triersOfKnown('password again', teacher, secret))
  if (!(await accounts.isPassword(teacher, password))) {
    const seconds = guess.wrong()
    throw seconds === 0 ? new Refusal(403, 'passwordWrong') : new Refusal(429, 'tooManyTries', { seconds })
  }
  guess.right()
}
