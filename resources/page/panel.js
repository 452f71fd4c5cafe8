// What can be chosen: the gradient and the method. Both are radio groups, one of whose buttons is on.

function radioButtons(group, choices, chosen) {
    const buttons = choices.map((choice, index) => {
        const button = document.createElement('button');
        button.type = 'button';
        button.role = 'radio';
        button.title = choice.note ?? choice.name;
        button.append(...choice.content);
        button.addEventListener('click', () => select(index));
        group.append(button);
        return button;
    });
    function select(index) {
        buttons.forEach((button, i) => {
            button.ariaChecked = String(i === index);
            button.tabIndex = i === index ? 0 : -1;
        });
        buttons[index].scrollIntoView({ block: 'nearest', inline: 'nearest' });
        chosen(choices[index]);
    }
    group.addEventListener('keydown', (event) => {
        const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
        if (!step) return;
        event.preventDefault();
        const next = (buttons.indexOf(document.activeElement) + step + buttons.length) % buttons.length;
        buttons[next].focus();
        select(next);
    });
    return select;
}

/// Colours (RGB in 16 bits) as a CSS gradient.
function cssGradient(colors) {
    const count = colors.length / 3, stops = Math.min(count, 24);
    const css = Array.from({ length: stops }, (_, i) => {
        const entry = 3 * Math.round(i / Math.max(stops - 1, 1) * (count - 1));
        return `rgb(${[0, 1, 2].map((k) => Math.round(colors[entry + k] / 257)).join(' ')})`;
    });
    return `linear-gradient(to right, ${css.length > 1 ? css : [css[0], css[0]]})`;
}

/// Gradients one above the other.
function stackedBars(gradients) {
    const share = 100 / gradients.length;
    const position = (i) => gradients.length === 1 ? 0 : i / (gradients.length - 1) * 100;
    return gradients.map((colors, i) => `${cssGradient(colors)} 0 ${position(i)}% / 100% ${share + 0.5}% no-repeat`).join(', ');
}

export function gradientBars(group, own, presets, chosen) {
    const choices = [{ name: 'Own paint', colors: null, bars: own }, ...presets.map(({ name, colors }) => ({ name, colors, bars: [colors] }))];
    for (const choice of choices) {
        const bar = document.createElement('i'), name = document.createElement('span');
        bar.style.background = stackedBars(choice.bars);
        name.textContent = choice.name;
        choice.content = [bar, name];
    }
    const select = radioButtons(group, choices, ({ name, colors }) => chosen(name, colors));
    return (name) => select(Math.max(0, choices.findIndex((choice) => choice.name === name)));
}

export function methodSwitch(group, chosen) {
    const choices = [
        { key: 'view-aligned', name: 'View-aligned', note: 'Strokes face you, and follow the object as it turns' },
        { key: 'view-dependent', name: 'View-dependent', note: 'Strokes stay where they are on the surface' },
    ];
    for (const choice of choices) choice.content = [choice.name];
    const select = radioButtons(group, choices, ({ key }) => chosen(key));
    return (key) => select(Math.max(0, choices.findIndex((choice) => choice.key === key)));
}
