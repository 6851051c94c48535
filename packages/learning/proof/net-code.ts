/** The rules of practice (neural-network/model.md) in NumPy: forward, back, update, for one example after the other. */
export const practise = `neurons = [np.array(names) for names in data["neurons"]]
shares = neurons[-1][0] == "softmax"
flat = ("start", "moves", "decay", "velocity", "squares")
p, moves, decay, velocity, squares = (np.array(data[name], dtype=float) for name in flat)
gradient = np.zeros_like(p)
beta1, beta2 = data["beta1"], data["beta2"]

def layers(flat):
    found, at, width = [], 0, data["inputs"]
    for names in neurons:
        end = at + width * len(names)
        found.append((flat[at:end].reshape(len(names), width), flat[end:end + len(names)]))
        at, width = end + len(names), len(names)
    return found

def f(names, z):
    if names[0] == "softmax":
        e = np.exp(z - z.max())
        return e / e.sum()
    with np.errstate(over="ignore"):
        all = [np.maximum(z, 0), np.tanh(z), 1 / (1 + np.exp(-z)), (z > 0) * 1.0]
    return np.select([names == n for n in ("relu", "tanh", "sigmoid", "threshold")], all, z)

def slope(names, z, y):
    all = [(z > 0) * 1.0, 1 - y * y, y * (1 - y), np.ones_like(z)]
    return np.select([names == n for n in ("relu", "tanh", "sigmoid", "identity")], all, 0.0)

def forward(x):
    z, y = [], [np.array(x)]
    for (w, b), names in zip(layers(p), neurons):
        z.append(b + w @ y[-1])
        y.append(f(names, z[-1]))
    return z, y

def back(x, t):
    z, y = forward(x)
    off = y[-1] - t
    delta = off if shares else 2 / len(t) * off * slope(neurons[-1], z[-1], y[-1])
    for k in reversed(range(len(neurons))):
        w, b = layers(gradient)[k]
        w += np.outer(delta, y[k])
        b += delta
        if k > 0:
            delta = (layers(p)[k][0].T @ delta) * slope(neurons[k - 1], z[k - 1], y[k])

def update(examples):
    global beta1, beta2
    g = (gradient / examples + decay * p) * moves
    if data["optimizer"] == "adam":
        beta1, beta2 = 0.9 * beta1, 0.999 * beta2
        velocity[:] = 0.9 * velocity + 0.1 * g
        squares[:] = 0.999 * squares + 0.001 * g * g
        p[:] -= data["rate"] / (1 - beta1) * velocity / (np.sqrt(squares / (1 - beta2)) + 1e-8)
    else:
        velocity[:] = data["momentum"] * velocity + g
        p[:] -= data["rate"] * velocity
    if data["range"] == "unit":
        for w, b in layers(p):
            w[:] = np.clip(w, 0, 1)
    gradient[:] = 0

for order in data["orders"]:
    for k in range(0, len(order), data["batch"]):
        batch = order[k:k + data["batch"]]
        for row in batch:
            back(data["inputsOf"][row], np.array(data["targetsOf"][row]))
        update(len(batch))`

/** How far off it is, in percent; where outputs share 100, the mean cross-entropy. */
export const measure = `def loss(x, t):
    z, y = forward(x)
    if shares:
        return np.sum(t * (z[-1].max() + np.log(np.sum(np.exp(z[-1] - z[-1].max()))) - z[-1]))
    return np.mean((y[-1] - t) ** 2)

mean = np.mean([loss(x, np.array(t)) for x, t in zip(data["testInputs"], data["testTargets"])])
number = mean if shares else 100 * np.sqrt(mean)`
