import type { Facts } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Settings } from '@botgarten/learning/q-learning'
import type { TableBrain } from '@botgarten/learning/q-senses'
import type { RobotConfig } from '@botgarten/simulation'
import type { Program } from '../types.ts'

/** Pybricks 4 on an EV3, ev3dev with python-ev3dev2, or Pybricks 4 on a SPIKE Prime hub. */
export type Dialect = 'pybricks' | 'ev3dev2' | 'spike'
export const dialects: readonly Dialect[] = ['pybricks', 'ev3dev2', 'spike']

/** Words for people, by message key. */
export type Say = (key: string, facts?: Facts) => string

export interface PythonInput {
  readonly name: string
  readonly program: Program
  readonly config: RobotConfig
  /** By the id of the network block. */
  readonly brains: { readonly [networkId: string]: Brain }
  /** By the id of the block that learned it by trying with the robot's sensors. */
  readonly tables?: { readonly [blockId: string]: TableBrain }
  /** Name of the weight set it drives with; '' or not given: the weights on the knobs. */
  readonly set?: string
  readonly dialect: Dialect
  /** `raise` where something is missing (the preset), or only a comment. */
  readonly gaps?: boolean
  readonly learned?: Learned
  /** Does the robot go on learning by itself? */
  readonly learner?: boolean
}

/** What learning has left behind. */
export interface Learned {
  /** The best way over a map: turns in degrees, to the right above 0, and lengths in cm. */
  readonly way?: readonly { readonly station: number; readonly turn: number; readonly length: number }[]
  /** Q-values by station, then by the next one. */
  readonly table?: { readonly [state: number]: { readonly [action: number]: number } }
  /** Middles of groups: red, green, blue, 0..255. */
  readonly centres?: readonly (readonly number[])[]
  /** What a robot needs to go on learning on a floor. */
  readonly lesson?: Lesson
}

/** A task of Q-learning on a floor with stations. */
export interface Lesson {
  readonly states: number
  readonly start: number
  /** Stations where an episode ends. */
  readonly ends: readonly number[]
  /** Stations at which a robot may be put down to begin elsewhere. */
  readonly open: readonly number[]
  /** By station, then by the next one: degrees clockwise from the right, cm, and what arriving pays. */
  readonly roads: {
    readonly [from: number]: {
      readonly [to: number]: {
        readonly direction: number
        readonly length: number
        readonly reward: number
      }
    }
  }
  readonly settings: Settings
}

/** Something that a block means and the brick cannot do, or that is not finished. */
export interface PythonNote {
  readonly block: string
  readonly text: string
  /** Not finished; false: finished, but the brick lacks it. */
  readonly gap: boolean
}

export interface PythonFile {
  readonly text: string
  /** Block ids of every line, the first line first. */
  readonly lines: readonly (readonly string[])[]
  /** So many lines at the head are imports, numbers and devices: none of them runs with a block. */
  readonly head: number
  readonly notes: readonly PythonNote[]
}

/** One logical line before it is wrapped. */
export interface Line {
  readonly code: string
  readonly depth: number
  readonly blocks: readonly string[]
}
