import { say } from '#words/say.ts'
import type { Finding } from '@botgarten/blocks'
import type { Difference } from '@botgarten/programs/open-roberta'
import type { FindingWords } from './frame.ts'

type Fix = NonNullable<Finding['fixes']>[number]

/** A finding in a child's words, with its ways out. */
export const wordsOf = (finding: Finding, mend: (fix: Fix) => void, putIn: () => void): FindingWords => ({
  title: say(`${finding.problem}.title`, finding.facts),
  text: say(`${finding.problem}.text`, finding.facts),
  fixes: [
    ...(finding.putIn ? [{ label: say(finding.putIn), mend: putIn }] : []),
    ...(finding.fixes ?? []).map((fix) => ({
      label: say(fix.words, fix.facts),
      mend: () => mend(fix),
    })),
  ],
})

/** What may end a program here and not in Open Roberta, with ways to the blocks. */
export const wordsOfDifferences = (
  differences: readonly Difference[],
  show: (block: string) => void,
): FindingWords => ({
  title: say('openRoberta.ends.title'),
  text: differences.map(({ kind }) => say(`openRoberta.ends.${kind}`)).join(' '),
  fixes: differences.map(({ kind, block }) => ({
    label: say(`openRoberta.ends.show.${kind}`),
    mend: () => show(block),
  })),
})

/** Is it a mistake that can be mended with one tap? Those are said at once; what is merely unfinished waits for Start. */
export const saidAtOnce = ({ stops, fixes }: Finding): boolean => stops && (fixes?.length ?? 0) > 0
