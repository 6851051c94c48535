import { beginAt, finishPhase } from '../k-means/sorting.ts'
import type { Distance, Points } from '../k-means/types.ts'
import { mostNumbers, type Proof } from './types.ts'

/** A sorting from its first centres on. */
export interface Sorted {
  readonly points: Points
  readonly centres: readonly (readonly number[])[]
  readonly distance: Distance
  /** So often all points have found their nearest centre. */
  readonly rounds: number
  /** Rounds before these centres, which are left out. */
  readonly before?: number
}

/** How far all points are from their centres, together; null: there are too many numbers for a file. */
export function kMeansProof({ points, centres, distance, rounds, before = 0 }: Sorted): Proof | null {
  const { values, features, count } = points
  if (values.length > mostNumbers) return null
  const rows = Array.from({ length: count }, (_, at) => [
    ...values.subarray(at * features, (at + 1) * features),
  ])
  return {
    method: 'k-means',
    number: inertiaAfter({ points, centres, distance, rounds }),
    before,
    data: { distance, rounds, centres, points: rows },
    ...{ learn: sort, show: 'number = inertia' },
  }
}

function inertiaAfter({ points, centres, distance, rounds }: Sorted): number {
  const sorting = beginAt(points, centres, distance)
  while (sorting.inertia.length < rounds && sorting.phase !== 'done') finishPhase(sorting)
  return sorting.inertia.at(-1) ?? 0
}

/** Lloyd's rounds. Sums go in the order of the points: equal distances are equal here, too. */
const sort = `X, C = np.array(data["points"], dtype=float), np.array(data["centres"], dtype=float)
points, groups, features = len(X), len(C), X.shape[1]

def summed(a):
    total = np.zeros(a.shape[:-1])
    for k in range(features):
        total += a[..., k]
    return total

def distances(C):
    gap = X[:, None, :] - C[None, :, :]
    if data["distance"] == "euclidean":
        return summed(gap * gap)
    if data["distance"] == "manhattan":
        return summed(np.abs(gap))
    a, b = summed(X * X)[:, None], summed(C * C)[None, :]
    with np.errstate(divide="ignore", invalid="ignore"):
        cos = summed(X[:, None, :] * C[None, :, :]) / (np.sqrt(a) * np.sqrt(b))
    return np.where((a == 0) | (b == 0), 1, 1 - cos)

def move(labels, C):
    own, away = labels.copy(), distances(C)[np.arange(points), labels]
    empty = [group for group in range(groups) if not (labels == group).any()]
    if empty and away.max() > 0:
        for group, point in zip(empty, np.argsort(-away, kind="stable")):
            own[point] = group
    moved = C.copy()
    for group in range(groups):
        members = X[own == group]
        if len(members) == 0:
            continue
        if data["distance"] == "manhattan":
            moved[group] = np.median(members, axis=0)
            continue
        if data["distance"] == "cosine":
            length = np.sqrt(summed(members * members))[:, None]
            members = np.divide(1, length, out=np.zeros_like(length), where=length > 0) * members
        moved[group] = np.cumsum(members, axis=0)[-1] / len(members)
    return moved

labels = None
for _ in range(data["rounds"]):
    if labels is not None:
        C = move(labels, C)
    d = distances(C)
    labels = d.argmin(axis=1)
inertia = d[np.arange(points), labels].sum()`
