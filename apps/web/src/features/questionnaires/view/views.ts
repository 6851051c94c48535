/** What a page of a form shows. */
const views = ['ask', 'results', 'paper', 'type', 'change'] as const
export type View = (typeof views)[number]

export const isView = (name: string | null): name is View => views.includes(name as View)
