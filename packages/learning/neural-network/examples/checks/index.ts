import { contradictions } from './contradictions.ts'
import { oddOnes } from './odd.ts'
import { allAlike, few, neverSeen, oneSided, sleeping } from './overall.ts'
import type { ExampleFinding, Table } from './types.ts'

export type { ExampleFinding, Table }

const checks = [contradictions, oddOnes, oneSided, neverSeen, allAlike, sleeping, few]

/** What to ask about the examples, the gravest first. An example is asked about once. */
export function findingsIn(table: Table): readonly ExampleFinding[] {
  const asked = new Set<number>()
  return checks
    .flatMap((check) => check(table))
    .filter((finding) => {
      if (!('row' in finding)) return true
      if (asked.has(finding.row)) return false
      asked.add(finding.row)
      return true
    })
}
