import type { Colour, SensorKind } from '@botgarten/simulation'
import type { Template, ValueType } from './program.ts'

export type Category =
  | 'control'
  | 'action'
  | 'sensors'
  | 'logic'
  | 'math'
  | 'text'
  | 'lists'
  | 'variables'
  | 'functions'
  | 'messages'
  | 'network'
  | 'q-learning'
  | 'sorting'

export type FieldLook =
  | {
      readonly name: string
      readonly kind: 'number'
      readonly preset: number
      readonly min?: number
      readonly max?: number
      readonly step?: number
    }
  | { readonly name: string; readonly kind: 'text'; readonly preset: string; readonly long?: true }
  /** A name of the program: the block makes such a thing, or uses one that is there. */
  | {
      readonly name: string
      readonly kind: 'name'
      readonly of: 'variable' | 'function' | 'neuron'
      readonly makes?: true
      readonly preset: string
    }
  /** A drop-down. `words` of an option: a message key, or null where the value itself is shown ("2", "C"). `dot`: a colour shown as a ringed dot. */
  | {
      readonly name: string
      readonly kind: 'choice'
      readonly preset: string
      readonly options: readonly {
        readonly value: string
        readonly words: string | null
        readonly dot?: Colour
        /** Shown instead of the value where there are no words: a name that a child has given. */
        readonly label?: string
      }[]
      /** Any number in this range may stand there too; it is shown as it is. */
      readonly numbers?: { readonly min: number; readonly max: number }
      /** A map of the project may stand there too, as `own:<id>`. */
      readonly own?: 'map'
    }
  /** In the file, never on the block. */
  | { readonly name: string; readonly kind: 'hidden'; readonly preset: string }

export type InputLook =
  | {
      readonly name: string
      readonly kind: 'value'
      readonly accepts: readonly ValueType[]
      /** The block runs without it, or says itself what is missing. */
      readonly optional?: true
      /** Names a variable that the block writes to: a variable block must stand here and is not asked. */
      readonly target?: true
      readonly when?: When
    }
  | {
      readonly name: string
      readonly kind: 'statements'
      /** Declarations stand here: variables of the program, or a function's parameters. */
      readonly holds?: 'variables' | 'parameters'
      readonly when?: When
    }

/** A part is there only while a field, or an attribute of the mutation, says one of these. */
export type When =
  | { readonly field: string; readonly is: readonly string[] }
  | { readonly attribute: string; readonly is: readonly string[] }

/** Shape as data. No functions, no sentences, no colours written out. */
export interface Look {
  readonly category: Category
  /** hat: starts a program · statement: has a row before and after · value: is plugged in · function: stands alone. */
  readonly shape: Shape
  /** What a value block gives; 'any': what fits (nothing, a list's entry before it is known). */
  readonly output?: ValueType | 'any'
  /** The block has another shape while `when` holds. */
  readonly also?: { readonly shape: Shape; readonly when: When }
  readonly typed?: Typed
  /** A layer between inputs and outputs, drawn with a frame of its own. */
  readonly layer?: 'hidden'
  readonly icon?: 'play' | 'network' | 'repeat' | 'map' | 'gear'
  readonly fields: readonly FieldLook[]
  readonly inputs: readonly InputLook[]
  /** A list that grows: `items` rows `ADD0…`, each with its own minus, a plus at its end (mutation `items`). */
  readonly items?: {
    readonly prefix: 'ADD'
    readonly min: number
    readonly max: number
    /** Where faces do not say it. */
    readonly accepts?: readonly ValueType[]
    readonly fresh?: Template
  }
  /** More ways of a decision or a wait: `IF1`, `DO1`, …, as many as the attribute of the mutation says. */
  readonly branches?: {
    readonly attribute: 'elseif' | 'wait'
    readonly value: 'IF' | 'WAIT'
    readonly most: number
  }
  /** Holes `ARG0`, …, one for each parameter of the function that is called (mutation's `args`). */
  readonly args?: true
  /** Message keys, one a row of the block; `{NAME}` in the message is where a field, an input or the {ICON} stands. */
  readonly rows: readonly string[]
  /** What the block always writes into its mutation besides `items`: a constant, or what one of its fields says. */
  readonly mutation?: { readonly [attribute: string]: Said }
  /** Faces of one type, told apart by a field or an attribute of the mutation. The look itself shows the preset's face. */
  readonly faces?: Faces
}

/** A constant · what a field says · 'true' while a field says one of these, else 'false'. */
type Said = string | { readonly field: string } | { readonly field: string; readonly is: readonly string[] }

export type Shape = 'hat' | 'statement' | 'value' | 'function'

/**
 * The block's type of value is chosen, in a field or in an attribute of its mutation, or follows what is plugged in.
 * `list`: the list type of it.
 */
export interface Typed {
  readonly by:
    | { readonly field: string }
    | { readonly attribute: string }
    /** As the block in this input gives, or as its list's entries. */
    | { readonly input: string; readonly entry?: true }
  readonly preset: ValueType
  readonly output?: 'type' | 'list'
  readonly inputs?: { readonly [name: string]: 'type' | 'list' }
  readonly items?: 'type'
}

export interface Faces {
  readonly by: { readonly field: string } | { readonly attribute: string }
  readonly of: { readonly [value: string]: Face }
}

export interface Face {
  readonly output: ValueType | 'any'
  /** Form of the plug; round where nothing is said. */
  readonly plug?: 'pointed' | 'round'
  /** Colour of the plug and of the list's edge. */
  readonly tint?: 'sensor' | 'actuator'
  readonly items?: {
    readonly accepts: readonly ValueType[]
    /** Message key beside the plus at the end. */
    readonly add: string
    /** What a new row comes with. */
    readonly fresh: Template
  }
}

/** A neuron block: what the playground writes beside its node and how it colours it. */
export interface NeuronLook {
  readonly layer: 'input' | 'output'
  /** Message key; gets the block's fields as parameters, as they are shown ("2", "green"). */
  readonly label: string
  /** Field that names the port, where there is one. */
  readonly port?: string
  /** `sensor` teal, `actuator` apricot, or the colour that stands in a field. */
  readonly colour: 'sensor' | 'actuator' | { readonly field: string }
  readonly sensor?: SensorKind
}
