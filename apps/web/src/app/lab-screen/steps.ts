import type { StepKind } from '@botgarten/lab'
import type { PaneName } from '#lab/panes.ts'
import { m } from '#words/message.ts'

/** What a step is in each pane (running.md 10). */
export const steps = {
  program: { kind: 'block', words: m['lab.stepBlock'], icon: 'shapes' },
  network: { kind: 'network', words: m['lab.stepNetwork'], icon: 'network' },
  world: { kind: 'tick', words: m['lab.stepWorld'], icon: 'compass' },
} as const satisfies {
  readonly [pane in PaneName]: { kind: StepKind; words: () => string; icon: string }
}

export const panesWithSteps = ['program', 'network', 'world'] as const
