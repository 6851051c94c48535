import { say } from '#lib/words/say.ts'
import type { Finding } from '@botgarten/blocks'
import type { FindingWords } from './parts/frame.ts'

/** A finding in a child's words, with its ways out. */
export const wordsOf = (finding: Finding, mend: (field: string, value: string) => void): FindingWords => ({
  title: say(`${finding.problem}.title`, finding.facts),
  text: say(`${finding.problem}.text`, finding.facts),
  fixes: (finding.fixes ?? []).map(({ field, value, words, facts }) => ({
    label: say(words, facts),
    mend: () => mend(field, value),
  })),
})

/** Is it a mistake that can be mended with one tap? Those are said at once; what is merely unfinished waits for Start. */
export const saidAtOnce = ({ stops, fixes }: Finding): boolean => stops && (fixes?.length ?? 0) > 0
