/** The three ways of learning that a form asks about; each has a picture `content/questionnaires/pictures/<topic>.svg`. */
export const topics = ['supervised', 'unsupervised', 'reinforcement'] as const
export type Topic = (typeof topics)[number]

/** When a form is filled in. */
export const moments = ['before', 'after', 'weeks'] as const
export type Moment = (typeof moments)[number]

/** `form.json` of a folder `content/questionnaires/<nn-id>/`, and of a form of a teacher's own. */
export interface Form {
  readonly id: string
  readonly moment: Moment
  /** In the order in which they are asked. */
  readonly items: readonly FormItem[]
  /** Ids of items that stand on one screen from grade 5 on. */
  readonly screens: readonly (readonly string[])[]
}

export type FormItem =
  /** 1 to 5, where more is more positive. Words of the five steps: section `<scale>` of the text. */
  | { readonly id: string; readonly kind: 'scale'; readonly scale: string; readonly topic?: Topic }
  | { readonly id: string; readonly kind: 'choice'; readonly choices: readonly string[] }
  /** A sentence of one's own. */
  | { readonly id: string; readonly kind: 'text' }
  /** What will Bo do? A question of `content/materials/questions/`, whose answer the simulation gives. */
  | { readonly id: string; readonly kind: 'robot'; readonly question: string; readonly topic: Topic }

/** A form in one language. */
export interface FormText {
  readonly title: string
  readonly lead: string
  /** By section: items (`question`, `here` beside its topic, `young`, choices), scales (`1` to `5`), topics (`label`, `title`, `reminder`). */
  readonly words: { readonly [section: string]: { readonly [key: string]: string } | undefined }
}

/** The five steps of a scale, from the most negative. */
export const steps = ['1', '2', '3', '4', '5'] as const
