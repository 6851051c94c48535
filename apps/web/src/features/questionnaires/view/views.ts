/** What a page of a form shows; `study`: the results of 2020. */
const views = ['ask', 'results', 'paper', 'type', 'change', 'study'] as const
export type View = (typeof views)[number]

export const isView = (name: string | null): name is View => views.includes(name as View)
