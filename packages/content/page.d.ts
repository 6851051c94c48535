// What the modules hold that `vite.ts` writes. Lists are there, what is opened comes by a promise.
declare module 'content:cards' {
  import type { Cards, Lazy } from '@botgarten/content/catalogue'
  const part: Lazy<Cards> & {
    /** Address of the picture on its front; null for what is no card or has none. */
    readonly pictureOfCard: (id: string) => string | null
  }
  export default part
}

declare module 'content:worlds' {
  import type { WorldFile } from '@botgarten/content'
  import type { Lazy, Worlds } from '@botgarten/content/catalogue'
  const part: Lazy<Worlds> & {
    /** Address of the picture of a floor; null for a floor without one. */
    readonly floorAddress: (world: Pick<WorldFile, 'floor'>) => string | null
    /** Address of its pixels, for the robot's sensors. */
    readonly pixelsAddress: (world: Pick<WorldFile, 'floor'>) => string | null
  }
  export default part
}

declare module 'content:maps' {
  import type { Lazy, Maps } from '@botgarten/content/catalogue'
  const part: Lazy<Maps>
  export default part
}

declare module 'content:zoo' {
  import type { Zoo } from '@botgarten/content/catalogue'
  const part: Zoo & {
    /** Address of the drawing of a cage's map. */
    readonly addressOf: (cage: string) => string
    readonly map: (cage: string) => Promise<string>
  }
  export default part
}

declare module 'content:senses' {
  import type { SenseZoo } from '@botgarten/content/catalogue'
  const part: SenseZoo & {
    /** Address of the picture of a cage's animal. */
    readonly pictureOf: (cage: string) => string
  }
  export default part
}

declare module 'content:courses' {
  import type { Course, LaneKind, Racer } from '@botgarten/experiments/brain-race'
  const all: readonly {
    readonly course: Course
    /** The brains that drive where nobody brings others. */
    readonly racers: { readonly [kind in LaneKind]: Racer | null }
  }[]
  export default all
}

declare module 'content:sets' {
  import type { Lazy, Sets } from '@botgarten/content/catalogue'
  const part: Lazy<Sets> & {
    /** Address of the picture of a thing. */
    readonly pictureOf: (set: string, thing: string) => string
  }
  export default part
}

declare module 'content:questionnaires' {
  import type { AskedQuestion, Questionnaires } from '@botgarten/content/catalogue'
  import type { Topic } from '@botgarten/content/questionnaires'
  const part: Questionnaires & {
    /** What a form can ask about Bo, with its words. */
    readonly asked: readonly AskedQuestion[]
    /** Addresses of the pictures above what is asked about a topic. */
    readonly pictures: { readonly [topic in Topic]: string }
  }
  export default part
}

declare module 'content:items' {
  import type { Items, Lazy } from '@botgarten/content/catalogue'
  const part: Lazy<Items> & {
    /** Address of a picture by its path below `content/materials`. */
    readonly pictureAt: (file: string) => Promise<string>
  }
  export default part
}

declare module 'content:programs' {
  import type { Lazy, Programs } from '@botgarten/content/catalogue'
  const part: Lazy<Programs>
  export default part
}
