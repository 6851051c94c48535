/** Does a list begin with all of another? Lists that only grow are compared by their ends. */
export const beginsWith = <T>(all: readonly T[], first: readonly T[]): boolean =>
  first.length <= all.length && first[0] === all[0] && first.at(-1) === all[first.length - 1]
