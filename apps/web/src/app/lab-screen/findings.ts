import { message } from '#words/message.ts'
import type { Finding } from '@botgarten/blocks'
import type { Difference } from '@botgarten/programs/open-roberta'

/** Something to fix, in a child's words. The first fix is the main button. */
export interface FindingWords {
  readonly title: string
  readonly text?: string
  readonly fixes: readonly { readonly label: string; readonly fix: () => void }[]
}

type Fix = NonNullable<Finding['fixes']>[number]

/** A finding in a child's words, with its ways out. */
export const wordsOf = (finding: Finding, apply: (fix: Fix) => void, putIn: () => void): FindingWords => ({
  title: message(`${finding.problem}.title`, finding.facts),
  text: message(`${finding.problem}.text`, finding.facts),
  fixes: [
    ...(finding.putIn ? [{ label: message(finding.putIn), fix: putIn }] : []),
    ...(finding.fixes ?? []).map((fix) => ({
      label: message(fix.words, fix.facts),
      fix: () => apply(fix),
    })),
  ],
})

/** What may end a program here and not in Open Roberta, with ways to the blocks. */
export const wordsOfDifferences = (
  differences: readonly Difference[],
  show: (block: string) => void,
): FindingWords => ({
  title: message('openRoberta.ends.title'),
  text: differences.map(({ kind }) => message(`openRoberta.ends.${kind}`)).join(' '),
  fixes: differences.map(({ kind, block }) => ({
    label: message(`openRoberta.ends.show.${kind}`),
    fix: () => show(block),
  })),
})

/** Is it a mistake that can be fixed with one tap? Those are said at once; what is merely unfinished waits for Start. */
export const saidAtOnce = ({ stops, fixes }: Finding): boolean => stops && (fixes?.length ?? 0) > 0

/** Blocks that have to be fixed first. */
export const stoppingBlocks = (findings: readonly Finding[]): ReadonlySet<string> =>
  new Set(findings.filter(({ stops }) => stops).map(({ block }) => block))
