/** The name under which a map of a project is learned on. */
export const ownId = (id: string) => `own:${id}`
