import type { MotorPlug, SensorKind } from '@botgarten/simulation'
import type { FieldLook, Template } from '../types.ts'

/** A block of a robot's configuration, as Open Roberta has it: the brick, or what is plugged into it. */
export interface Part {
  readonly type: string
  /** What it is on the robot. */
  readonly is:
    | { readonly brick: true }
    | { readonly motor: MotorPlug['kind'] }
    | { readonly sensor: SensorKind; readonly maker?: 'hitechnic' }
  readonly fields: readonly FieldLook[]
  /** Message keys: `help` is one sentence for the child. */
  readonly words: { readonly name: string; readonly help: string }
  /** A robot with it, and a small program that needs it. */
  readonly example: {
    readonly plugged: { readonly [port: string]: Template }
    readonly brick?: Template['fields']
    readonly program: readonly Template[]
  }
}

/** Words of a part, by what follows `robBrick_`. */
export const wordsOf = (name: string, section: 'kind' | 'plug' = 'plug'): Part['words'] => ({
  name: `robot.${section}.${name}`,
  help: `robot.help.${name}`,
})
