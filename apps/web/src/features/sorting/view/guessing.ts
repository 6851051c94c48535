import { m } from '#words/message.ts'
import type { GuessingGame } from '../model/guessing-game.svelte.ts'
import { featureName } from './messages.ts'

/** Who does what next. */
export function nextIn({ stage, round, rounds }: GuessingGame): string {
  if (stage === 'choose') return m['sorting.guess.first']()
  if (stage !== 'sort') return m['sorting.guess.second']()
  if (round === 0) return m['sorting.guess.watch']()
  return round < rounds.length ? m['sorting.guess.round']({ number: round }) : m['sorting.guess.rest']()
}

/** How the guess was; '' before there is one. */
export function answerIn({ stage, secret, verdict }: GuessingGame): string {
  const list = secret.map((feature) => featureName(feature)).join(' + ')
  if (stage === 'shown') return m['sorting.guess.was']({ list })
  switch (verdict?.kind) {
    case 'right':
      return m['sorting.guess.right']({ list })
    case 'alike':
      return m['sorting.guess.alike']({ list })
    case 'wrong':
      return m['sorting.guess.wrong']({ found: verdict.found, of: verdict.of })
    case undefined:
      return ''
  }
}
