import type { NetworkInUse } from '@botgarten/programs'
import { m, message } from '#words/message.ts'

/** Why a network does not run, and what the press is called that changes it. */
export interface IdleNote {
  readonly title: string
  readonly text: string
  readonly label: string
}

/** `putIn`: the label of the fix for a loose network, where it has one of its own. */
export function idleNote(idle: NetworkInUse['idle'], putIn: string | undefined): IdleNote | null {
  if (idle === null) return null
  if (idle === 'off')
    return { title: m['network.off'](), text: m['network.offText'](), label: m['network.switchOn']() }
  const problem = idle === 'behind' ? 'networkBehind' : 'looseNetwork'
  return {
    title: m[`problem.${problem}.title`](),
    text: m[`problem.${problem}.text`](),
    label: message(putIn ?? 'problem.fix.intoLoop'),
  }
}
